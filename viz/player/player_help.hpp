#pragma once
/// \file
/// The page that says what the player's keys and the mouse do.

#include "viz/flat/stage_picture.hpp"

namespace rayproof::viz {

/// In a slide's place.
[[nodiscard]] Picture help_picture(const Stage& stage);

}  // namespace rayproof::viz
