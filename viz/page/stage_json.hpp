#pragma once
/// \file
/// A stage as JSON: what the page bears, and what any other sink or test may read.

#include <string>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// One line. Numbers are JSON numbers that read back as the same double, or the case format's strings for
/// what is not finite; each value also bears its `shown` decimal, the shortest that reads back in the
/// precision.
[[nodiscard]] std::string stage_json(const Stage& stage);

/// Of each step the camera, the bodies, the labels as HTML, the floor, and the slider's ray, all in the
/// coordinates of the step's view, to 4 decimals (a hundredth of a pixel); see viz/scene/space.hpp.
[[nodiscard]] std::string space_json(const Stage& stage);

}  // namespace rayproof::viz
