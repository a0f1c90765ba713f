#pragma once
/// \file
/// Looking at a stage from another side.

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// The camera after the scene was turned before it: what is nearest to the eye moves by `right` radians to
/// the right and by `up` radians upward. The axes stay unit vectors at right angles to a few ulps however
/// often it is turned. A flat camera stays as it is.
[[nodiscard]] StageCamera turned(const StageCamera& camera, double right, double up);

}  // namespace rayproof::viz
