#pragma once
/// \file
/// From which side a ray and a figure are seen best.

#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// From where neither the ray is seen end-on nor a surface with one of the given normals edge-on; the ray
/// runs to the right. All are unit vectors.
[[nodiscard]] StageCamera chosen_camera(const glm::dvec3& along_ray, const std::vector<glm::dvec3>& normals);

}  // namespace rayproof::viz
