#pragma once
/// \file
/// What stands in the window beside the scene.

#include "viz/picture/picture.hpp"
#include "viz/player/player.hpp"

namespace rayproof::viz {

/// The slide's title, caption and numbers, what the arrow keys move or why a case was refused, t and what
/// changes with it. The faces of widgets are not in it.
[[nodiscard]] Picture window_sheet(const Player& player);

}  // namespace rayproof::viz
