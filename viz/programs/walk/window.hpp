#pragma once
/// \file
/// `rayproof walk --window`: walkthroughs in a window, made again of every case that a drag makes.

#include <string>
#include <vector>

#include "viz/stage/player.hpp"

namespace rayproof::viz {

/// The lessons of a topic; again with the lesson's method.
[[nodiscard]] std::vector<Play> plays_of(const std::string& topic);
/// The stage of any case; again with the same method.
[[nodiscard]] std::vector<Play> plays_of(const Stage& stage);

/// Returns when the user quits. Throws std::runtime_error with one sentence where there is no display to show
/// a window, or no VTK to make one.
void show_window(std::vector<Play> plays);

}  // namespace rayproof::viz
