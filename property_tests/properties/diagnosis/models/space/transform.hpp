#pragma once
/// \file
/// Readings of a case by subjects that use its transform wrongly; none where there is no transform.

#include <cmath>
#include <glm/matrix.hpp>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/models.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {

/// @{ The transform is ignored; used as its own inverse; with rows and columns exchanged, without its
/// translation or beside it; without its translation; with its opposite; with that undone after the matrix,
/// not before.
[[nodiscard]] std::vector<Case> without_transform(const Case& one);
[[nodiscard]] std::vector<Case> with_inverse_transform(const Case& one);
[[nodiscard]] std::vector<Case> with_transposed_transform(const Case& one);
[[nodiscard]] std::vector<Case> without_translation(const Case& one);
[[nodiscard]] std::vector<Case> translation_negated(const Case& one);
[[nodiscard]] std::vector<Case> translation_undone_last(const Case& one);
/// @}

/// Of the matrix the diagonal and the translation alone are looked at.
[[nodiscard]] std::vector<Case> diagonal_alone(const Case& one);
/// The direction is translated as if it were a point (w = 1).
[[nodiscard]] std::vector<Case> direction_as_point(const Case& one);
/// The direction stays what it is in the world.
[[nodiscard]] std::vector<Case> direction_not_transformed(const Case& one);
/// @{ The direction, or the origin, is taken into object space by the matrix, not by its inverse.
[[nodiscard]] std::vector<Case> direction_by_matrix(const Case& one);
[[nodiscard]] std::vector<Case> origin_by_matrix(const Case& one);
/// @}
/// The inverse is the matrix of cofactors, which is not divided by the determinant.
[[nodiscard]] std::vector<Case> inverse_undivided(const Case& one);
/// The origin stays what it is in the world.
[[nodiscard]] std::vector<Case> origin_not_transformed(const Case& one);

/// A solid that is placed by a matrix that mirrors is missed; of flat figures it may be one side alone.
[[nodiscard]] inline Answers mirrored_missed(const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !asked->transform || lies_in_a_plane(one) || !finds_something(exact)) return {};
  return glm::determinant(glm::dmat3(*asked->transform)) < 0 ? Answers{RayAnswer{}} : Answers{};
}

/// What a matrix of a determinant below 10^power puts into the world is missed.
template <int power>
[[nodiscard]] Answers small_determinant_missed(const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !asked->transform || !finds_something(exact)) return {};
  const double size = std::abs(glm::determinant(glm::dmat3(*asked->transform)));
  return size < std::pow(10.0, power) ? Answers{RayAnswer{}} : Answers{};
}

}  // namespace rayproof::diagnosis
