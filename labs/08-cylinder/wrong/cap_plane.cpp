// Diagnosis: the whole plane of a cap is hit
#include "cylinder.hpp"

#include <algorithm>

std::vector<double> cylinder(vec3 origin, vec3 direction, double t_min, double t_max, double rx, double ry,
                             double height, bool capped) {
  const double ox = origin.x / rx, oy = origin.y / ry, dx = direction.x / rx, dy = direction.y / ry;
  std::vector<double> hits;

  // The side: a circle of radius 1 once x and y are divided by the radii.
  const double a = dx * dx + dy * dy;
  const double b = ox * dx + oy * dy;
  const double c = ox * ox + oy * oy - 1;
  const double D = b * b - a * c;
  if (a > 0 && D >= 0) {
    for (const double t : {(-b - sqrt(D)) / a, (-b + sqrt(D)) / a}) {
      const double z = origin.z + t * direction.z;
      if (0 <= z && z <= height) hits.push_back(t);
    }
  }

  // The caps: planes, hit inside the ellipse.
  if (capped && direction.z != 0) {
    for (const double z : {0.0, height}) {
      const double t = (z - origin.z) / direction.z;
      const double x = ox + t * dx, y = oy + t * dy;
      hits.push_back(t);
    }
  }

  std::erase_if(hits, [&](double t) { return t < t_min || t > t_max; });
  std::sort(hits.begin(), hits.end());
  return hits;
}
