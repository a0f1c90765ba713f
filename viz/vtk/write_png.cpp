#include "viz/vtk/write_png.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
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

Raster pixels_of(vtkRenderWindow& window) {
  window.Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(&window);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->Update();
  vtkImageData& image = *filter->GetOutput();
  const int* const size = image.GetDimensions();
  Raster raster(size[0], size[1], {});
  for (int y = 0; y < raster.height; ++y) {
    // VTK's first row is the lowest.
    const auto* row = static_cast<const unsigned char*>(image.GetScalarPointer(0, raster.height - 1 - y, 0));
    for (int x = 0; x < raster.width; ++x, row += 3) std::copy_n(row, 3, raster.at(x, y).begin());
  }
  return raster;
}

void use_legible_font(vtkTextProperty& text, bool bold) {
  const std::string file =
      std::string(RAYPROOF_FONT_DIR) + (bold ? "/DejaVuSans-Bold.ttf" : "/DejaVuSans.ttf");
  if (!std::filesystem::exists(file)) return;
  text.SetFontFamily(VTK_FONT_FILE);
  text.SetFontFile(file.c_str());
}

}  // namespace rayproof::viz
