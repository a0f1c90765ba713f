#pragma once
/// \file
/// The floor below a scene in space.

#include <algorithm>
#include <array>
#include <cmath>
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

/// How far apart the grid's lines are in the world: 1, 2 or 5 times a power of ten.
[[nodiscard]] inline double grid_step(double radius) {
  const double rough = radius / 2;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= rough) return factor * power;
  }
  return power;
}

inline constexpr double clearance = 0.12;   ///< between the lowest thing and the floor
inline constexpr double sheet_gap = 0.002;  ///< between the floor, its grid and the shadows

[[nodiscard]] inline int axis_of(const glm::dvec3& up) {
  for (int i = 0; i < 2; ++i) {
    if (up[i] != 0) return i;
  }
  return 2;
}

inline void add_lines(SpaceFloor& floor, const StageView& view) {
  const double step = grid_step(view.radius) / view.radius;
  for (std::size_t k = 0; k < 2; ++k) {
    const double offset = std::fmod(view.centre[floor.across(k)] / view.radius, step);
    const double first = std::ceil((-floor_reach + offset) / step) * step - offset;
    for (double at = first; at <= floor_reach; at += step) floor.lines[k].push_back(at);
  }
}

[[nodiscard]] inline SpaceFloor floor_below(const std::vector<glm::dvec3>& points, const glm::dvec3& up,
                                            const StageView& view) {
  SpaceFloor floor;
  floor.axis = axis_of(up);
  double lowest = -0.3;
  for (const glm::dvec3& p : points) lowest = std::min(lowest, up[floor.axis] * p[floor.axis]);
  const double height = lowest - clearance;
  floor.shadows = up[floor.axis] * height;
  floor.grid = up[floor.axis] * (height - sheet_gap);
  floor.ground = up[floor.axis] * (height - 2 * sheet_gap);
  add_lines(floor, view);
  return floor;
}

}  // namespace rayproof::viz
