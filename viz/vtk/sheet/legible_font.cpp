#include "viz/vtk/sheet/legible_font.hpp"

#include <vtkTextProperty.h>

#include <filesystem>
#include <string>

namespace rayproof::viz {

void use_legible_font(vtkTextProperty& text, bool bold) {
  const std::string file =
      std::string(RAYPROOF_FONT_DIR) + (bold ? "/DejaVuSans-Bold.ttf" : "/DejaVuSans.ttf");
  if (!std::filesystem::exists(file)) return;
  text.SetFontFamily(VTK_FONT_FILE);
  text.SetFontFile(file.c_str());
}

}  // namespace rayproof::viz
