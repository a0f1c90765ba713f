#pragma once
/// \file
/// `rayproof walk --window`: walkthroughs in a window, made again of every case that a drag makes.

#include <optional>
#include <string>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Shows the stage of one case, or else the lessons of a topic; returns when the user quits. Throws
/// std::runtime_error with one sentence where there is no display to show a window, or no VTK to make one.
void show_window(const std::optional<Stage>& one, const std::string& topic);

}  // namespace rayproof::viz
