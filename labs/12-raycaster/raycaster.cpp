#include "raycaster.hpp"

/// For each pixel the index of the sphere that is seen at its middle, or -1. Rows from the top, each from
/// left to right.
std::vector<int> raycaster(const PinholeCamera& camera, const std::vector<SceneSphere>& /*spheres*/) {
  std::vector<int> picture;
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) picture.push_back(-1);  // your ray, your spheres
  return picture;
}
