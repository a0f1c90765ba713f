// Diagnosis: hits behind the ray's beginning are reported
#include "plane.hpp"

std::optional<double> plane(vec3 origin, vec3 direction, double, double t_max, vec3 normal, double d) {
  const double slope = dot(normal, direction);
  if (slope == 0) return std::nullopt;
  const double t = -(dot(normal, origin) + d) / slope;
  if (t > t_max) return std::nullopt;
  return t;
}
