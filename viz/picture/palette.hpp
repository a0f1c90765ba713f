#pragma once
/// \file
/// One colour for each role, safe for colour-blind readers (M. Okabe, K. Ito, "Color Universal Design",
/// 2008), darkened or lightened where needed to contrast 4.5:1 or more as text, and as a label's large text
/// 3:1 or more before a surface.

#include <array>
#include <cstddef>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

struct RoleColour {
  const char* name;   ///< CSS class
  const char* light;  ///< on white, #rrggbb
  const char* dark;   ///< on near-black
};

/// In the order of Role.
inline constexpr std::array<RoleColour, role_count> palette{{
    {"background", "#ffffff", "#16181c"},
    {"frame", "#b8bec6", "#4a515c"},
    {"text", "#16181c", "#e8eaed"},
    {"muted", "#4a525b", "#a3abb5"},
    {"surface", "#0072b2", "#56b4e9"},
    {"ray", "#16181c", "#e8eaed"},
    {"exact", "#006243", "#2fc99a"},
    {"claimed", "#9a3d00", "#ff8f4d"},
    {"nearest", "#81396a", "#e29ac6"},
    {"normal", "#654a00", "#e8c547"},
    {"edge", "#00527f", "#8ecbf0"},
}};

[[nodiscard]] constexpr const RoleColour& colour_of(Role role) {
  return palette[static_cast<std::size_t>(role)];
}

/// The floor below a scene in space.
struct FloorColours {
  RoleColour ground{"ground", "#f4f5f7", "#1d2026"};
  RoleColour grid{"grid", "#d1d6de", "#343a44"};
  RoleColour shadow{"shadow", "#d6dbe0", "#0e1013"};
};
inline constexpr FloorColours floor_colours{};

/// How much of the colour an area's tint keeps.
inline constexpr double area_opacity = 0.13;

}  // namespace rayproof::viz
