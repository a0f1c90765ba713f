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

/// Twice the area that the vertices enclose, in the plane of two of their axes.
template <class Vertices, class X, class Y>
double area_of(const Vertices& vertices, const X& x, const Y& y) {
  double area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& from = vertices[i];
    const auto& to = vertices[(i + 1) % vertices.size()];
    area += x(from) * y(to) - x(to) * y(from);
  }
  return area;
}

template <class Vertices, class Same>
bool have_repeated_neighbours(const Vertices& vertices, const Same& same) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (same(vertices[i], vertices[(i + 1) % vertices.size()])) return true;
  return false;
}

bool is_proper_polygon(const std::vector<Vec2<double>>& vertices) {
  const auto x = [](const auto& v) { return v.x; };
  const auto y = [](const auto& v) { return v.y; };
  const auto same = [](const auto& a, const auto& b) { return a.x == b.x && a.y == b.y; };
  return area_of(vertices, x, y) != 0 && !have_repeated_neighbours(vertices, same);
}

bool is_proper_polygon(const std::vector<glm::dvec3>& vertices) {
  const auto x = [](const auto& v) { return v.x; };
  const auto y = [](const auto& v) { return v.y; };
  const auto z = [](const auto& v) { return v.z; };
  const bool has_area =
      area_of(vertices, x, y) != 0 || area_of(vertices, y, z) != 0 || area_of(vertices, z, x) != 0;
  return has_area && !have_repeated_neighbours(vertices, [](const auto& a, const auto& b) { return a == b; });
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
