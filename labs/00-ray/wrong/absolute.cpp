// Diagnosis: t is taken without its sign
#include "ray.hpp"

#include <algorithm>

double ray(vec3 origin, vec3 direction, double t_min, double t_max, vec3 point) {
  const double t = dot(point - origin, direction) / dot(direction, direction);
  return std::clamp(std::abs(t), t_min, t_max);
}
