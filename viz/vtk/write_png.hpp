#pragma once
/// \file
/// Writing what VTK draws, and making its text legible.

#include <string>

#include "viz/picture/raster.hpp"

class vtkRenderWindow;
class vtkTextProperty;

namespace rayproof::viz {

/// Renders the window off-screen at its size and writes it as an RGB PNG. Needs a display (OffscreenDisplay).
/// Throws std::runtime_error with one sentence where the file can't be written.
void write_png(vtkRenderWindow& window, const std::string& path);

/// Renders the window at its size. Needs a display (OffscreenDisplay, UserDisplay).
[[nodiscard]] Raster pixels_of(vtkRenderWindow& window);

/// Sets the DejaVu Sans font, which has the λ, √, subscripts, ∈ and ∞ that VTK's built-in font silently
/// drops; the built-in font where DejaVu is not installed.
void use_legible_font(vtkTextProperty& text, bool bold = false);

}  // namespace rayproof::viz
