#pragma once
/// \file
/// Readings of a box whose middle or half size is taken wrongly.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ The whole size stands for half of it; min + max for the middle.
[[nodiscard]] std::vector<Case> size_as_half(const Case& one);
[[nodiscard]] std::vector<Case> sum_as_middle(const Case& one);
/// @}
}  // namespace rayproof::diagnosis
