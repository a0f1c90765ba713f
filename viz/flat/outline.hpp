#pragma once
/// \file
/// What of a surface a drawing shows: its fill, the lines that are seen, and those behind it.

#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

using WorldLine = std::vector<glm::dvec3>;

struct SurfaceOutline {
  std::vector<WorldLine> filled{};  ///< rings; the even-odd rule fills them
  std::vector<WorldLine> seen{};
  std::vector<WorldLine> hidden{};
};

/// Of a solid its edges and where it turns away from the camera, of an ellipsoid the latter. A polygon has no
/// line around it but what other items draw.
[[nodiscard]] SurfaceOutline surface_outline(const StageItem& surface, const StageCamera& camera);

}  // namespace rayproof::viz
