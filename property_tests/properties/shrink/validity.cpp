#include "properties/shrink/validity.hpp"

#include <cmath>

#include "case/accepted.hpp"
#include "properties/numbers.hpp"

namespace rayproof {

namespace {

bool may_be(const CaseNumber& number) {
  if (std::isfinite(*number.value)) return true;
  if (number.field == "ray.t_min") return *number.value == -infinity<double>;
  return number.field == "ray.t_max" && *number.value == infinity<double>;
}

/// The coordinates of a point by name, as members.
template <class Point>
using Axes = std::initializer_list<double Point::*>;

/// Twice the area that the vertices enclose, in the plane of two of their axes.
template <class Point>
double area_of(const std::vector<Point>& vertices, double Point::*x, double Point::*y) {
  double area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point& from = vertices[i];
    const Point& to = vertices[(i + 1) % vertices.size()];
    area += from.*x * to.*y - to.*x * from.*y;
  }
  return area;
}

template <class Point>
bool is_proper_polygon(const std::vector<Point>& vertices, Axes<Point> axes) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point& next = vertices[(i + 1) % vertices.size()];
    if (std::ranges::all_of(axes, [&](auto axis) { return vertices[i].*axis == next.*axis; })) return false;
  }
  for (const auto x : axes)
    for (const auto y : axes)
      if (x != y && area_of(vertices, x, y) != 0) return true;
  return false;
}

bool is_proper_polygon(const std::vector<Vec2<double>>& vertices) {
  return is_proper_polygon(vertices, {&Vec2<double>::x, &Vec2<double>::y});
}

bool is_proper_polygon(const std::vector<glm::dvec3>& vertices) {
  return is_proper_polygon(vertices, {&glm::dvec3::x, &glm::dvec3::y, &glm::dvec3::z});
}

template <class Shape>
bool is_proper_shape(const Shape& /*always so*/) {
  return true;
}
bool is_proper_shape(const Polygon<double>& polygon) { return is_proper_polygon(polygon.vertices); }
bool is_proper_shape(const Triangle<double>& t) { return are_independent(t.b - t.a, t.c - t.a); }
bool is_proper_shape(const Cylinder<double>& cylinder) { return cylinder.height > 0; }
bool is_proper_shape(const Box<double>& box) {
  return box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
}

}  // namespace

bool is_proper(const Case& one) {
  if (const auto* place = std::get_if<PointAndPolygon<double>>(&one.question))
    return is_proper_polygon(place->vertices);
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  return asked == nullptr ||
         std::visit([](const auto& shape) { return is_proper_shape(shape); }, asked->shape);
}

bool is_valid(const Case& one) {
  Case copy = one;
  for (const CaseNumber& number : numbers_of(copy))
    if (!may_be(number)) return false;
  return std::visit([](const auto& asked) { return is_accepted(asked); }, one.question);
}

}  // namespace rayproof
