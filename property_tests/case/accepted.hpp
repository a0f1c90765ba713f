#pragma once
/// \file
/// What the case format would refuse, asked of a question that nobody has read: a generated or a shrunk one.

#include <utility>

#include "case/case.hpp"
#include "case/independent.hpp"

namespace rayproof {

/// Whether the format takes a shape, or a question without a ray, of finite numbers.
template <class S>
[[nodiscard]] bool is_accepted(const S& shape) {
  try {
    ShapeFormat<S>::validate(shape);
    return true;
  } catch (const Refusal&) {
    return false;
  }
}
/// The same of a ray and its shape.
[[nodiscard]] inline bool is_accepted(const RayQuestion& asked) {
  const auto [t_min, t_max] = std::pair(asked.ray.t_min, asked.ray.t_max);
  if (asked.ray.direction == glm::dvec3(0) || !(t_min <= t_max)) return false;
  if (t_min == infinity<double> || t_max == -infinity<double>) return false;
  if (asked.transform && !is_regular(*asked.transform)) return false;
  return std::visit([](const auto& shape) { return is_accepted(shape); }, asked.shape);
}

}  // namespace rayproof
