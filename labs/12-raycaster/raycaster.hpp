#pragma once
#include <glm/glm.hpp>
#include <vector>

using vec3 = glm::dvec3;

struct PinholeCamera {
  vec3 eye, target, up;  // up need not be perpendicular to the view
  double angle;          // of view, from the lower edge of the picture to the upper one, in degrees
  int width, height;     // in pixels, which are squares
};

struct SceneSphere {
  vec3 center;
  double radius;
};

std::vector<int> raycaster(const PinholeCamera& camera, const std::vector<SceneSphere>& spheres);
