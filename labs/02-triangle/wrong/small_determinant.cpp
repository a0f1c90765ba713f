// Diagnosis: absolute epsilon
#include "triangle.hpp"

std::optional<vec3> triangle(vec3 origin, vec3 direction, double t_min, double t_max, vec3 a, vec3 b,
                             vec3 c) {
  const vec3 e1 = b - a, e2 = c - a;
  const vec3 s = origin - a;
  const vec3 p = cross(direction, e2), q = cross(s, e1);
  const double det = dot(e1, p);
  if (det < 1e-4 && det > -1e-4) return std::nullopt;
  const double t = dot(e2, q) / det;
  const double u = dot(s, p) / det;
  const double v = dot(direction, q) / det;
  if (u < 0 || v < 0) return std::nullopt;
  if (u + v > 1) return std::nullopt;
  if (t < t_min || t > t_max) return std::nullopt;
  return vec3(t, u, v);
}
