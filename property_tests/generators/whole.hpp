#pragma once
/// \file
/// What the families `whole` are made of: scenes of numbers so short that a plain method rounds none of them,
/// and with rays aimed where a single comparison decides.

#include "generators/layout.hpp"

namespace rayproof {

/// A vector of components 0, ±1, ±2 and ±4, not zero: the largest component is a power of two, and to divide
/// by any of them rounds nothing. A third of them along an axis.
[[nodiscard]] inline glm::dvec3 short_vector(Random& random) {
  glm::dvec3 v = whole_vector(random, 4);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(v[axis]) == 3) v[axis] = std::copysign(4, v[axis]);
  return v;
}

/// A number of quarters from `low` to `high` wholes.
[[nodiscard]] inline double quarters(Random& random, int low, int high) {
  return random.between(4 * low, 4 * high) / 4.0;
}

/// Ends of the interval at the hit or beside it for a third of the rays, whole lines and rays turned round
/// for another.
inline void vary_exactly(Random& random, Precision precision, Scene& scene) {
  const int kind = random.between(0, 2);
  if (kind == 0) cut(random, precision, scene);
  if (kind == 1) scene = loosened(random, scene);
}

/// The family `whole` of a layout whose numbers are short.
template <auto layout>
[[nodiscard]] Family in_whole_numbers(const char* description, std::vector<MinimumShare> shares) {
  return {"whole", description, ask<layout, vary_exactly>, std::move(shares)};
}

}  // namespace rayproof
