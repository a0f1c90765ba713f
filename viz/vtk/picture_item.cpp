#include "viz/vtk/picture_item.hpp"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <numbers>

#include "viz/dashes.hpp"
#include "viz/palette.hpp"
#include "viz/vtk/write_png.hpp"

namespace rayproof::viz {
namespace {

/// "#rrggbb" to three bytes.
void light_colour(Role role, unsigned char rgb[3]) {
  const unsigned long value = std::stoul(colour_of(role).light + 1, nullptr, 16);
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<unsigned char>(value >> (16 - 8 * i));
}

/// Paints a picture's elements with VTK's two-dimensional painter, whose y points up.
class Painter {
 public:
  Painter(vtkContext2D& context, const PictureItem& item)
      : context_(context),
        left_(item.left),
        top_(item.bottom + item.picture->height * item.scale),
        scale_(item.scale) {}

  void operator()(const Area& area) {
    set_brush(area.role, area_opacity);
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    auto xy = flat(area.points);
    context_.DrawPolygon(xy.data(), static_cast<int>(area.points.size()));
  }
  void operator()(const Line& line) {
    for (const auto& dash : dashes_of(line)) stroke(line.role, dash, line.width);
  }
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
    vtkTextProperty& property = *context_.GetTextProp();
    use_legible_font(property, text.bold);
    property.SetFontSize(static_cast<int>(std::lround(text.size * scale_)));
    property.SetJustification(static_cast<int>(text.anchor));
    property.SetVerticalJustificationToBottom();
    const double y = text.at.y + descent * text.size;
    if (text.halo) {
      for (const Point& off : circle({0, 0}, 2))
        write(Role::background, {text.at.x + off.x, y + off.y}, text.text);
    }
    write(text.role, {text.at.x, y}, text.text);
  }

 private:
  /// VTK puts the bottom of the line at the given point, not the baseline; DejaVu Sans reaches this far
  /// below.
  static constexpr double descent = 0.21;

  [[nodiscard]] float to_x(double x) const { return static_cast<float>(left_ + x * scale_); }
  [[nodiscard]] float to_y(double y) const { return static_cast<float>(top_ - y * scale_); }
  [[nodiscard]] std::vector<float> flat(const std::vector<Point>& points) const {
    std::vector<float> xy;
    for (const Point& p : points) {
      xy.push_back(to_x(p.x));
      xy.push_back(to_y(p.y));
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
  void write(Role role, const Point& at, const std::string& text) {
    unsigned char rgb[3];
    light_colour(role, rgb);
    context_.GetTextProp()->SetColor(rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
    context_.DrawString(to_x(at.x), to_y(at.y), text.c_str());
  }
  void set_brush(Role role, double opacity) {
    unsigned char rgb[3];
    light_colour(role, rgb);
    context_.GetBrush()->SetColor(rgb[0], rgb[1], rgb[2],
                                  static_cast<unsigned char>(std::lround(255 * opacity)));
  }
  void fill(Role role, const std::vector<Point>& points) {
    set_brush(role, 1);
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    auto xy = flat(points);
    context_.DrawPolygon(xy.data(), static_cast<int>(points.size()));
  }
  void stroke(Role role, const std::vector<Point>& points, double width) {
    unsigned char rgb[3];
    light_colour(role, rgb);
    context_.GetPen()->SetLineType(vtkPen::SOLID_LINE);
    context_.GetPen()->SetColor(rgb[0], rgb[1], rgb[2], 255);
    context_.GetPen()->SetWidth(static_cast<float>(width * scale_));
    auto xy = flat(points);
    context_.DrawPoly(xy.data(), static_cast<int>(points.size()));
  }

  vtkContext2D& context_;
  double left_, top_;
  double scale_;
};

}  // namespace

vtkStandardNewMacro(PictureItem)

    bool PictureItem::Paint(vtkContext2D* context) {
  Painter painter(*context, *this);
  for (const Element& element : picture->elements) std::visit(painter, element);
  return true;
}

}  // namespace rayproof::viz
