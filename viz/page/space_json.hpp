#pragma once
/// \file
/// A stage in space as the pages' script reads it.

#include <string>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Of each step the camera, the bodies, the labels as HTML, the floor, and the slider's ray, all in the
/// coordinates of the step's view, to 5 decimals (a hundredth of a pixel); see viz/scene/space.hpp.
[[nodiscard]] std::string space_json(const Stage& stage);

}  // namespace rayproof::viz
