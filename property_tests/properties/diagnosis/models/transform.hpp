#pragma once
/// \file
/// Readings of a case by subjects that use its transform wrongly; none where there is no transform.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ The transform is ignored; used as its own inverse; with rows and columns exchanged; without its
/// translation.
[[nodiscard]] std::vector<Case> without_transform(const Case& one);
[[nodiscard]] std::vector<Case> with_inverse_transform(const Case& one);
[[nodiscard]] std::vector<Case> with_transposed_transform(const Case& one);
[[nodiscard]] std::vector<Case> without_translation(const Case& one);
/// @}

/// The direction is translated as if it were a point (w = 1).
[[nodiscard]] std::vector<Case> direction_as_point(const Case& one);
/// The direction stays what it is in the world.
[[nodiscard]] std::vector<Case> direction_not_transformed(const Case& one);
/// The origin stays what it is in the world.
[[nodiscard]] std::vector<Case> origin_not_transformed(const Case& one);

}  // namespace rayproof::diagnosis
