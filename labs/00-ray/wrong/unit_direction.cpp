// Diagnosis: the direction is taken for a unit vector
#include "ray.hpp"

#include <algorithm>

double ray(vec3 origin, vec3 direction, double t_min, double t_max, vec3 point) {
  return std::clamp(dot(point - origin, direction), t_min, t_max);
}
