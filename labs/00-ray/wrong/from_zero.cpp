// Diagnosis: it takes 0 for the ray's beginning in place of t_min
#include "ray.hpp"

#include <algorithm>

double ray(vec3 origin, vec3 direction, double /*t_min*/, double t_max, vec3 point) {
  const double t = dot(point - origin, direction) / dot(direction, direction);
  return t < 0 ? 0 : std::min(t, t_max);
}
