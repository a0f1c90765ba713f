#include "viz/vtk/write_png.hpp"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace rayproof::viz {

void write_png(vtkRenderWindow& window, const std::string& path) {
  // VTK's writer only logs a failure: find out beforehand whether the file can be written.
  if (!std::ofstream(path, std::ios::binary))
    throw std::runtime_error("the file " + path + " can't be written");
  window.SetOffScreenRendering(1);
  window.Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(&window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
}

void use_legible_font(vtkTextProperty& text, bool bold) {
  const std::string file =
      std::string(RAYPROOF_FONT_DIR) + (bold ? "/DejaVuSans-Bold.ttf" : "/DejaVuSans.ttf");
  if (!std::filesystem::exists(file)) return;
  text.SetFontFamily(VTK_FONT_FILE);
  text.SetFontFile(file.c_str());
}

}  // namespace rayproof::viz
