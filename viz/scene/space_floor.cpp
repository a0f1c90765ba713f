#include "viz/scene/space.hpp"

#include <algorithm>
#include <cmath>

namespace rayproof::viz {
namespace {

constexpr double clearance = 0.12;   ///< between the lowest thing and the floor
constexpr double sheet_gap = 0.002;  ///< between the floor, its grid and the shadows

int axis_of(const glm::dvec3& up) {
  for (int i = 0; i < 2; ++i) {
    if (up[i] != 0) return i;
  }
  return 2;
}

void add_lines(SpaceFloor& floor, const StageView& view) {
  const double step = grid_step(view.radius) / view.radius;
  for (std::size_t k = 0; k < 2; ++k) {
    const double offset = std::fmod(view.centre[floor.across(k)] / view.radius, step);
    const double first = std::ceil((-floor_reach + offset) / step) * step - offset;
    for (double at = first; at <= floor_reach; at += step) floor.lines[k].push_back(at);
  }
}

}  // namespace

double grid_step(double radius) {
  const double rough = radius / 2;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= rough) return factor * power;
  }
  return power;
}

SpaceFloor floor_below(const std::vector<glm::dvec3>& points, const glm::dvec3& up, const StageView& view) {
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
