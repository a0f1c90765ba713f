#pragma once
/// \file
/// How bad a guest's finding is.

#include <array>
#include <string_view>

#include "properties/finding.hpp"

namespace rayproof {

enum class FindingKind {
  gross,     ///< wrong in ordinary numbers, far from every boundary
  boundary,  ///< right but for edges, vertices, tangents, the ends of the interval
  range,     ///< wrong at very large or very small numbers
  rounding,  ///< digits are lost
  protocol   ///< no answer, a crash, silence, nonsense
};

/// The name in the findings file.
[[nodiscard]] constexpr std::string_view name_of(FindingKind kind) {
  constexpr std::array<std::string_view, 5> names{"gross", "boundary", "range", "rounding", "protocol"};
  return names.at(static_cast<std::size_t>(kind));
}

/// The kind of a finding, by its shrunk case and what was answered to that.
[[nodiscard]] FindingKind kind_of(const Finding& finding);

}  // namespace rayproof
