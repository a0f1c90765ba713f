#pragma once
/// \file
/// Models of faults in the barycentric coordinates of the first hit, which are right but for their places.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The barycentric coordinates in another order: place i holds the one that belongs in `order i`.
template <int x, int y, int z>
[[nodiscard]] Answers in_order(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->barycentric) return {};
  RayAnswer permuted = *answer;
  const glm::dvec3& own = *answer->barycentric;
  permuted.barycentric = {own[x], own[y], own[z]};
  return {permuted};
}

/// Beta, gamma and t in the places of alpha, beta and gamma.
[[nodiscard]] inline Answers weights_and_t(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->barycentric) return {};
  RayAnswer shifted = *answer;
  shifted.barycentric = {answer->barycentric->y, answer->barycentric->z, answer->hits.t[0]};
  return {shifted};
}

/// One barycentric coordinate is wrong, and the two others are right.
template <int place>
[[nodiscard]] std::optional<bool> weight_is_wrong(const Case& /*one*/, const Answer& got,
                                                  const Answer& exact) {
  const auto *mine = std::get_if<RayAnswer>(&got), *answer = std::get_if<RayAnswer>(&exact);
  if (mine == nullptr || answer == nullptr || !mine->barycentric || !answer->barycentric) return std::nullopt;
  const auto is_right = [&](int i) {
    return std::abs((*mine->barycentric)[i] - (*answer->barycentric)[i]) < 0x1p-12;
  };
  if (is_right(0) && is_right(1) && is_right(2)) return std::nullopt;
  return !is_right(place) && is_right((place + 1) % 3) && is_right((place + 2) % 3);
}

}  // namespace rayproof::diagnosis
