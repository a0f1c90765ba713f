// Diagnosis: the origin is left out
#include "ray.hpp"

#include <algorithm>

double ray(vec3 /*origin*/, vec3 direction, double t_min, double t_max, vec3 point) {
  return std::clamp(dot(point, direction) / dot(direction, direction), t_min, t_max);
}
