#include "ray.hpp"

#include <algorithm>

double ray(vec3 origin, vec3 direction, double t_min, double t_max, vec3 point) {
  const double t = dot(point - origin, direction) / dot(direction, direction);
  return std::clamp(t, t_min, t_max);
}
