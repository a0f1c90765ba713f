#pragma once
/// \file
/// A picture as an item of a VTK scene, and its text, painted by VTK's two-dimensional painter.

#include <vtkContextItem.h>

#include "viz/picture/picture.hpp"

class vtkContext2D;
class vtkTextProperty;

namespace rayproof::viz {

/// Paints `picture`, which must outlive it, in its light colours with VTK's two-dimensional painter. Its
/// lower left corner lies at (left, bottom) of the scene, `scale` pixels stand for each of the picture's.
class PictureItem : public vtkContextItem {
 public:
  static PictureItem* New();

  const Picture* picture = nullptr;
  double scale = 1;
  double left = 0;
  double bottom = 0;
  /// Of as many parts of the picture's elements, the one to paint.
  std::size_t part = 0;
  std::size_t parts = 1;

  bool Paint(vtkContext2D* context) override;
};

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
