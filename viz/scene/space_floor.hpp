#pragma once
/// \file
/// A floor below a scene, with a grid and shadows, so that heights and depths can be read.

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Level to an axis of the world, in the view's coordinates. The ground, the grid on it and the shadows on
/// that lie a sheet apart.
struct SpaceFloor {
  int axis = 2;
  double ground = 0;   ///< its coordinate on the axis
  double grid = 0;     ///< the grid's
  double shadows = 0;  ///< that of the shadows, which fall straight down
  /// Where the grid's lines cross the axis after this one, and the one after that: at round coordinates of
  /// the world.
  std::array<std::vector<double>, 2> lines{};

  [[nodiscard]] int across(std::size_t k) const { return (axis + 1 + static_cast<int>(k)) % 3; }
};

/// How far the floor reaches to each side, in the view's radii.
inline constexpr double floor_reach = 5;

/// Below the lowest of the points.
[[nodiscard]] SpaceFloor floor_below(const std::vector<glm::dvec3>& points, const glm::dvec3& up,
                                     const StageView& view);

/// How far apart the grid's lines are in the world: 1, 2 or 5 times a power of ten.
[[nodiscard]] double grid_step(double radius);

}  // namespace rayproof::viz
