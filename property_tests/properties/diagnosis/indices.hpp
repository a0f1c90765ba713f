#pragma once
/// \file
/// Some of the failing cases of a diagnosis.

#include <cstddef>
#include <vector>

namespace rayproof::diagnosis {

/// Failing cases, by index.
using Indices = std::vector<std::size_t>;

/// All indices below `count`.
[[nodiscard]] Indices all_of(std::size_t count);
/// Those of `some` that are not among `others`; both ascend.
[[nodiscard]] Indices without(const Indices& some, const Indices& others);
/// @{ Those of both, and those of either; all ascend.
[[nodiscard]] Indices common(const Indices& a, const Indices& b);
[[nodiscard]] Indices united(const Indices& a, const Indices& b);
/// @}

}  // namespace rayproof::diagnosis
