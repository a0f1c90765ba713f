#include "properties/diagnosis/models/hits/starts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

/// A miss where the origin lies on that side of the surface: 1 for where the normal points.
Answers missed_from(const Case& one, const Answer& exact, double side) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->normal || !lies_in_a_plane(one)) return {};
  const double above = -answer->hits.t[0] * glm::dot(*answer->normal, ray_question(one)->ray.direction);
  return side * above > 0 ? Answers{RayAnswer{}} : Answers{};
}

/// Of spheres another model speaks.
struct MiddleOf {
  template <class Shape>
  std::optional<glm::dvec3> operator()(const Shape& /*has none*/) const {
    return std::nullopt;
  }
  std::optional<glm::dvec3> operator()(const Triangle<double>& shape) const {
    return (shape.a + shape.b + shape.c) / 3.0;
  }
  std::optional<glm::dvec3> operator()(const Polygon<double>& shape) const {
    glm::dvec3 sum(0);
    for (const glm::dvec3& vertex : shape.vertices) sum += vertex;
    return sum / static_cast<double>(shape.vertices.size());
  }
  std::optional<glm::dvec3> operator()(const Box<double>& shape) const {
    return (shape.min + shape.max) / 2.0;
  }
  std::optional<glm::dvec3> operator()(const Parallelepiped<double>& shape) const {
    return shape.corner + (shape.edges[0] + shape.edges[1] + shape.edges[2]) / 2.0;
  }
};

}  // namespace

Answers missed_with_middle_behind(const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !finds_something(exact)) return {};
  const auto middle = std::visit(MiddleOf{}, asked->shape);
  const Ray<double> ray = ray_in_object(*asked);
  const bool is_behind = middle && glm::dot(*middle - ray.origin, ray.direction) < 0;
  return is_behind ? Answers{RayAnswer{}} : Answers{};
}

Answers missed_from_front(const Case& one, const Answer& exact) { return missed_from(one, exact, 1); }
Answers missed_from_back(const Case& one, const Answer& exact) { return missed_from(one, exact, -1); }

}  // namespace rayproof::diagnosis
