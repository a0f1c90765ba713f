#include "viz/vtk/sheet/picture_item.hpp"

#include <vtkContext2D.h>
#include <vtkObjectFactory.h>

#include "viz/vtk/sheet/picture_text.hpp"

namespace rayproof::viz {
namespace {

/// Paints a picture's elements with VTK's two-dimensional painter, whose y points up.
class ItemPainter {
 public:
  ItemPainter(vtkContext2D& context, const PictureItem& item)
      : context_(context),
        left_(item.left),
        top_(item.bottom + item.picture->height * item.scale),
        scale_(item.scale) {}

  void operator()(const Area& /*area*/) {}  // surfaces are bodies of the scene below
  void operator()(const Window& /*window*/) {}
  void operator()(const PixelLine& line) {
    std::vector<Point> points;
    for (const Point& p : line.points) points.push_back(placed(p));
    paint_line(context_, line.role, points, line.width * scale_);
  }
  /// As letters of DejaVu Sans, whose edges are smooth; the painter's own are not.
  void operator()(const Mark& mark) {
    constexpr double disc = 0.763;  // its diameter, in em
    const auto letter = [&](Role role, const char* sign, double size) {
      const double middle = mark.shape == MarkShape::cross ? 0.365 : 0.259;  // its height, in em
      (*this)(Text{role, {mark.at.x, mark.at.y + middle * size}, sign, Anchor::middle, size});
    };
    switch (mark.shape) {
      case MarkShape::dot:
        return letter(mark.role, "●", 9 / disc);
      case MarkShape::ring:
        letter(mark.role, "●", (2 * mark_radius + 2.5) / disc);
        return letter(Role::background, "●", (2 * mark_radius - 2.5) / disc);
      case MarkShape::diamond:
        return letter(mark.role, "◆", 2 * mark_radius / disc);
      case MarkShape::cross:
        return letter(mark.role, "✖", 20);
    }
  }
  void operator()(const Text& text) {
    const Point at = placed(text.at);
    paint_text(context_, text, at.x, at.y, scale_);
  }

 private:
  [[nodiscard]] Point placed(const Point& p) const { return {left_ + p.x * scale_, top_ - p.y * scale_}; }

  vtkContext2D& context_;
  double left_, top_;
  double scale_;
};

}  // namespace

vtkStandardNewMacro(PictureItem);

bool PictureItem::Paint(vtkContext2D* context) {
  ItemPainter painter(*context, *this);
  const std::size_t count = picture->elements.size();
  for (std::size_t i = part * count / parts; i < (part + 1) * count / parts; ++i)
    std::visit(painter, picture->elements[i]);
  return true;
}

}  // namespace rayproof::viz
