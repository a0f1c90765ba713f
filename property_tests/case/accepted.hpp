#pragma once
/// \file
/// What the case format would refuse, asked of a question that nobody has read: a generated or a shrunk one.

#include "case/case.hpp"
#include "case/independent.hpp"

namespace rayproof {

/// Whether the format takes a question of finite numbers.
[[nodiscard]] inline bool is_accepted(const RayQuestion& asked) {
  if (asked.ray.direction == glm::dvec3(0) || !(asked.ray.t_min <= asked.ray.t_max)) return false;
  if (asked.transform && !is_regular(*asked.transform)) return false;
  try {
    std::visit([]<class S>(const S& shape) { ShapeFormat<S>::validate(shape); }, asked.shape);
  } catch (const Refusal&) {
    return false;
  }
  return true;
}
[[nodiscard]] inline bool is_accepted(const Quadratic<double>& /*any finite numbers will do*/) {
  return true;
}
[[nodiscard]] inline bool is_accepted(const PointAndPolygon<double>& asked) {
  return asked.vertices.size() >= 3;
}

}  // namespace rayproof
