#include <algorithm>
#include <cmath>

#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

bool is_flat(const Shape& shape) {
  return !std::holds_alternative<Sphere<double>>(shape) && !std::holds_alternative<Box<double>>(shape) &&
         !std::holds_alternative<Parallelepiped<double>>(shape) &&
         !std::holds_alternative<Cylinder<double>>(shape);
}

}  // namespace

Cases steeper(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !is_flat(asked->shape)) return {};
  const RayAnswer line = hits_of_line(one);
  if (line.hits.count != 1 || !line.normal || !std::isfinite(line.hits.t[0])) return {};
  const double length = glm::length(asked->ray.direction);
  const double slope = glm::dot(asked->ray.direction, *line.normal) / length;
  if (std::abs(slope) > 0.25) return {};
  return with_question(one, [&](RayQuestion& changed) {
    glm::dvec3 direction = changed.ray.direction + (slope < 0 ? -length : length) * *line.normal;
    direction *= length / glm::length(direction);
    changed.ray.origin += line.hits.t[0] * (changed.ray.direction - direction);
    changed.ray.direction = direction;
    return true;
  });
}

Cases wider(const Case& one) {
  return with_shape<Triangle<double>>(one, [&](RayQuestion& asked, Triangle<double>& triangle) {
    const RayAnswer line = hits_of_line(one);
    if (asked.transform || !line.barycentric) return false;
    const glm::dvec3 u = triangle.b - triangle.a, v = triangle.c - triangle.a;
    const double size = std::max({glm::length(u), glm::length(v), glm::length(triangle.c - triangle.b)});
    const glm::dvec3 normal = glm::normalize(glm::cross(u, v)), along = glm::normalize(u);
    const auto point_of = [&] {
      const glm::dvec3& w = *line.barycentric;
      return w.x * triangle.a + w.y * triangle.b + w.z * triangle.c;
    };
    const glm::dvec3 before = point_of();
    triangle.b = triangle.a + size * along;
    triangle.c = triangle.a + size * glm::cross(normal, along);
    asked.ray.origin += point_of() - before;
    return true;
  });
}

}  // namespace rayproof::diagnosis
