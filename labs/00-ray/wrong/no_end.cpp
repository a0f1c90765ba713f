// Diagnosis: it goes beyond the end of the ray
#include "ray.hpp"

#include <algorithm>

double ray(vec3 origin, vec3 direction, double t_min, double /*t_max*/, vec3 point) {
  return std::max(dot(point - origin, direction) / dot(direction, direction), t_min);
}
