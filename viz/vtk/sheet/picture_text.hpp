#pragma once
/// \file
/// A picture's text, painted by VTK's two-dimensional painter.

#include "viz/picture/picture.hpp"

class vtkContext2D;
class vtkTextProperty;

namespace rayproof::viz {

/// Paints the text with its anchor at (x, y) of the context, whose y points up; `scale` of the context's
/// pixels stand for each of the picture's. Hats above letters ("d̂") are strokes: VTK knows no combining
/// characters.
void paint_text(vtkContext2D& context, const Text& text, double x, double y, double scale);

/// Draws a line through points of the context, x and y in turn.
void stroke(vtkContext2D& context, Role role, std::vector<float> xy, double width);

/// Sets the DejaVu Sans font, which has the λ, √, subscripts, ∈ and ∞ that VTK's built-in font silently
/// drops; the built-in font where DejaVu is not installed.
void use_legible_font(vtkTextProperty& text, bool bold = false);

}  // namespace rayproof::viz
