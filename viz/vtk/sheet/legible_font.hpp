#pragma once
/// \file
/// Making VTK's text legible.

class vtkTextProperty;

namespace rayproof::viz {

/// Sets the DejaVu Sans font, which has the λ, √, subscripts, ∈ and ∞ that VTK's built-in font silently
/// drops; the built-in font where DejaVu is not installed.
void use_legible_font(vtkTextProperty& text, bool bold = false);

}  // namespace rayproof::viz
