#pragma once
/// \file
/// How bad a fault is.

#include <array>
#include <string_view>

namespace rayproof {

/// The worst first.
enum class FindingKind {
  gross,     ///< wrong in ordinary numbers, far from every boundary
  protocol,  ///< no answer, a crash, silence, nonsense
  boundary,  ///< right but for edges, vertices, tangents, the ends of the interval
  range,     ///< wrong at very large or very small numbers
  rounding   ///< digits are lost
};

/// The names in the findings file, the worst first.
inline constexpr std::array<std::string_view, 5> kind_names{"gross", "protocol", "boundary", "range",
                                                            "rounding"};

/// The name in the findings file.
[[nodiscard]] constexpr std::string_view name_of(FindingKind kind) {
  return kind_names.at(static_cast<std::size_t>(kind));
}

}  // namespace rayproof
