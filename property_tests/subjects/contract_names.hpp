#pragma once
/// \file
/// The names that claims and standings have in listings and on command lines.

#include <array>
#include <rayproof/method/contract.hpp>
#include <string_view>

namespace rayproof {

/// In the order of `Claim`.
inline constexpr std::array<std::string_view, claim_count> claim_names{
    "verdict", "residual", "ulp",   "robust", "ascending", "moved",
    "scaled",  "reversed", "batch", "nan",    "bounded",   "contact"};

[[nodiscard]] constexpr std::string_view claim_name(Claim claim) {
  return claim_names.at(static_cast<std::size_t>(claim));
}

/// In the order of `Standing`.
inline constexpr std::array<std::string_view, 3> standing_names{"sound", "naive", "printed"};

[[nodiscard]] constexpr std::string_view standing_name(Standing standing) {
  return standing_names.at(static_cast<std::size_t>(standing));
}

}  // namespace rayproof
