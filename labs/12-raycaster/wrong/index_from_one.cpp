// Diagnosis: the index of the first sphere is 0
#include "raycaster.hpp"

#include <cmath>
#include <limits>

namespace {

/// The smallest t > 0, or infinity.
double first_hit(vec3 origin, vec3 direction, const SceneSphere& sphere) {
  const vec3 f = origin - sphere.center;
  const double a = dot(direction, direction), b = dot(f, direction);
  const double D = b * b - a * (dot(f, f) - sphere.radius * sphere.radius);
  if (D >= 0)
    for (const double t : {(-b - std::sqrt(D)) / a, (-b + std::sqrt(D)) / a})
      if (t > 0) return t;
  return std::numeric_limits<double>::infinity();
}

int nearest_sphere(vec3 origin, vec3 direction, const std::vector<SceneSphere>& spheres) {
  double best = std::numeric_limits<double>::infinity();
  int nearest = -1;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double t = first_hit(origin, direction, spheres[i]);
    if (t >= best) continue;
    best = t;
    nearest = static_cast<int>(i) + 1;
  }
  return nearest;
}

}  // namespace

std::vector<int> raycaster(const PinholeCamera& camera, const std::vector<SceneSphere>& spheres) {
  const vec3 w = normalize(camera.eye - camera.target), u = normalize(cross(camera.up, w)), v = cross(w, u);
  const double top = std::tan(glm::radians(camera.angle) / 2), right = top * camera.width / camera.height;
  std::vector<int> picture;
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const double x = right * (2 * (column + 0.5) / camera.width - 1);
      const double y = top * (1 - 2 * (row + 0.5) / camera.height);
      picture.push_back(nearest_sphere(camera.eye, x * u + y * v - w, spheres));
    }
  return picture;
}
