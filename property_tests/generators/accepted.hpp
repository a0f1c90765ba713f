#pragma once
/// \file
/// Draws again what the case format would refuse: rounding can make vectors dependent and a normal zero.

#include "case/case.hpp"
#include "case/independent.hpp"

namespace rayproof {

/// Whether the format takes a question of finite numbers and an interval in order.
[[nodiscard]] inline bool is_accepted(const RayQuestion& asked) {
  if (asked.ray.direction == glm::dvec3(0)) return false;
  if (asked.transform && !is_regular(*asked.transform)) return false;
  try {
    std::visit([]<class S>(const S& shape) { ShapeFormat<S>::validate(shape); }, asked.shape);
  } catch (const Refusal&) {
    return false;
  }
  return true;
}

/// The first of the questions from `draw()` that the format takes.
template <class Draw>
[[nodiscard]] RayQuestion first_accepted(Draw&& draw) {
  for (;;) {
    RayQuestion asked = draw();
    if (is_accepted(asked)) return asked;
  }
}

}  // namespace rayproof
