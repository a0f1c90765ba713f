#pragma once
/// \file
/// A ray and a figure: from which side they are seen, and where the ray passes nearest to the outline.

#include <optional>
#include <vector>

#include "case/answer.hpp"
#include "viz/scene/stage.hpp"
#include "viz/shapes/figure.hpp"

namespace rayproof::viz {

/// The question in the world.
struct RayScene {
  Sight sight;
  Figure figure;
  Place along_ray;  ///< the direction, of unit length

  [[nodiscard]] Place at(const Shadow& t) const { return point_at(sight.ray, t); }
  [[nodiscard]] StageCamera camera() const;
};
[[nodiscard]] RayScene scene_of(const Case& one, const Answer* exact, const Answer* claimed);

/// Where the ray passes nearest to the outline.
struct NearestPass {
  const Border* border;  ///< of the scene's figure
  Shadow t;
  Place on_outline;
  Shadow gap;
};
[[nodiscard]] std::optional<NearestPass> nearest_of(const RayScene& scene);

/// From where neither the ray is seen end-on nor a surface with one of the given normals edge-on; the ray
/// runs to the right. All are unit vectors.
[[nodiscard]] StageCamera chosen_camera(const glm::dvec3& along_ray, const std::vector<glm::dvec3>& normals);

}  // namespace rayproof::viz
