// Diagnosis: right with the other sign
#include "plane.hpp"

std::optional<double> plane(vec3 origin, vec3 direction, double t_min, double t_max, vec3 normal, double d) {
  const double slope = dot(normal, direction);
  if (slope == 0) return std::nullopt;
  const double t = (dot(normal, origin) + d) / slope;
  if (t < t_min || t > t_max) return std::nullopt;
  return t;
}
