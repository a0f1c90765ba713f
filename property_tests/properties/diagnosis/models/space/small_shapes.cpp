#include "properties/diagnosis/models/space/small_shapes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

double area(std::span<const glm::dvec3> vertices) {
  glm::dvec3 twice(0);
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
    twice += glm::cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
  return glm::length(twice) / 2;
}

std::optional<double> least_thickness(const Case& one) {
  if (const auto* sphere = shape_in<Sphere<double>>(one)) return sphere->radius;
  if (const auto* cylinder = shape_in<Cylinder<double>>(one))
    return std::min({cylinder->rx, cylinder->ry, cylinder->height});
  const auto* box = shape_in<Box<double>>(one);
  if (box == nullptr) return std::nullopt;
  const glm::dvec3 sides = box->max - box->min;
  return std::min({sides.x, sides.y, sides.z});
}

std::optional<double> area_in(const Case& one) {
  if (const auto* triangle = shape_in<Triangle<double>>(one))
    return area(std::array{triangle->a, triangle->b, triangle->c});
  const auto* polygon = shape_in<Polygon<double>>(one);
  return polygon == nullptr ? std::nullopt : std::optional(area(polygon->vertices));
}

}  // namespace

Answers thin_solid_missed(const Case& one, const Answer& exact, double least) {
  const std::optional<double> thickness = least_thickness(one);
  return thickness && *thickness < least && finds_something(exact) ? Answers{RayAnswer{}} : Answers{};
}

Answers small_area_missed(const Case& one, const Answer& exact, double least) {
  const std::optional<double> area = area_in(one);
  if (!area || *area >= least || !finds_something(exact)) return {};
  return 2 * *area < least ? Answers{RayAnswer{}} : Answers{RayAnswer{}, exact};
}

bool has_some_size(const Case& one, const Answer& /*exact*/) {
  return least_thickness(one).value_or(0) > 0 || area_in(one).value_or(0) > 0;
}

bool has_component_below(const Case& one, double least) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return false;
  const glm::dvec3 d = ray_in_object(*asked).direction;
  const auto is_small = [&](double x) { return x != 0 && std::abs(x) < least; };
  return is_small(d.x) || is_small(d.y) || is_small(d.z);
}

std::vector<Case> components_raised(const Case& one, double least) {
  std::vector<Case> all;
  for (const bool keeps_signs : {true, false}) {
    const auto raised = with_question(one, [&](RayQuestion& asked) {
      asked.ray = ray_in_object(asked);
      asked.transform.reset();
      const glm::dvec3 given = asked.ray.direction;
      for (int axis = 0; axis < 3; ++axis) {
        double& x = asked.ray.direction[axis];
        if (std::abs(x) < least) x = keeps_signs ? std::copysign(least, x) : least;
      }
      return asked.ray.direction != given;
    });
    all.insert(all.end(), raised.begin(), raised.end());
  }
  return all;
}

}  // namespace rayproof::diagnosis
