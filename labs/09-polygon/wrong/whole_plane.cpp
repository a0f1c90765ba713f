// Diagnosis: whole plane
#include "polygon.hpp"

std::optional<double> polygon(vec3 origin, vec3 direction, double t_min, double t_max,
                              const std::vector<vec3>& vertices) {
  vec3 n(0), a = vertices.back() - vertices[0];
  for (const vec3& vertex : vertices) {
    const vec3 b = vertex - vertices[0];
    n += cross(a, b);
    a = b;
  }
  const double slope = dot(n, direction);
  if (slope == 0) return std::nullopt;
  const double t = dot(n, vertices[0] - origin) / slope;
  if (t < t_min || t > t_max) return std::nullopt;
  return t;
}
