#pragma once
/// \file
/// Whether an affine transform can be inverted, decided exactly.

#include <glm/mat4x4.hpp>

namespace rayproof {

/// Whether the determinant of the linear part (the upper left 3×3) is not zero. Exact for all finite doubles,
/// subnormals and 2^±1000 included. (The last row being 0 0 0 1, it is the determinant of the whole.)
[[nodiscard]] bool is_regular(const glm::dmat4& transform);

}  // namespace rayproof
