#pragma once
/// \file
/// Whether vectors are independent, decided exactly: what the format refuses must not hang on a rounding.
/// Exact for all finite doubles, subnormals and 2^±1000 included.

#include <glm/mat4x4.hpp>

namespace rayproof {

/// Whether a × b is not zero.
[[nodiscard]] bool are_independent(const glm::dvec3& a, const glm::dvec3& b);

/// Whether the determinant of the columns a, b, c is not zero.
[[nodiscard]] bool are_independent(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Whether the linear part (the upper left 3×3) of an affine transform can be inverted. (The last row being
/// 0 0 0 1, so can the whole.)
[[nodiscard]] inline bool is_regular(const glm::dmat4& transform) {
  return are_independent(glm::dvec3(transform[0]), glm::dvec3(transform[1]), glm::dvec3(transform[2]));
}

}  // namespace rayproof
