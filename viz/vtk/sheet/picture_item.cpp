#include "viz/vtk/sheet/picture_item.hpp"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

#include <cmath>
#include <numbers>

#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"

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
  void operator()(const PixelLine& line) { stroke(line.role, line.points, line.width); }
  void operator()(const Mark& mark) {
    const double r = mark_radius;
    const auto [x, y] = mark.at;
    switch (mark.shape) {
      case MarkShape::dot:
        return fill(mark.role, circle(mark.at, 4.5));
      case MarkShape::ring:
        return stroke(mark.role, circle(mark.at, r), 2.5);
      case MarkShape::diamond:
        return fill(mark.role, {{x - r, y}, {x, y + r}, {x + r, y}, {x, y - r}});
      case MarkShape::cross:
        stroke(mark.role, {{x - r, y - r}, {x + r, y + r}}, 2.5);
        stroke(mark.role, {{x - r, y + r}, {x + r, y - r}}, 2.5);
    }
  }
  void operator()(const Text& text) {
    paint_text(context_, text, left_ + text.at.x * scale_, top_ - text.at.y * scale_, scale_);
  }

 private:
  [[nodiscard]] std::vector<float> flat(const std::vector<Point>& points) const {
    std::vector<float> xy;
    for (const Point& p : points) {
      xy.push_back(static_cast<float>(left_ + p.x * scale_));
      xy.push_back(static_cast<float>(top_ - p.y * scale_));
    }
    return xy;
  }
  [[nodiscard]] static std::vector<Point> circle(const Point& centre, double radius) {
    std::vector<Point> outline;
    for (int i = 0; i <= 48; ++i) {
      const double angle = 2 * std::numbers::pi * i / 48;
      outline.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return outline;
  }
  void fill(Role role, const std::vector<Point>& points) {
    const auto [red, green, blue] = rgb_of(colour_of(role).light);
    context_.GetBrush()->SetColor(red, green, blue, 255);
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    auto xy = flat(points);
    context_.DrawPolygon(xy.data(), static_cast<int>(points.size()));
  }
  void stroke(Role role, const std::vector<Point>& points, double width) {
    viz::stroke(context_, role, flat(points), width * scale_);
  }

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
