// Diagnosis: a ray meets two neighbours at different places
#include "watertight.hpp"

std::optional<double> watertight(vec3 origin, vec3 direction, double t_min, double t_max, vec3 a, vec3 b,
                                 vec3 c) {
  const vec3 e1 = b - a, e2 = c - a, s = origin - a;
  const vec3 p = cross(direction, e2), q = cross(s, e1);
  const double det = dot(e1, p);
  if (det == 0) return std::nullopt;
  const double t = dot(e2, q) / det, u = dot(s, p) / det, v = dot(direction, q) / det;
  if (u < -0.01 || v < -0.01 || u + v > 1.01) return std::nullopt;
  if (t < t_min || t > t_max) return std::nullopt;
  return t;
}
