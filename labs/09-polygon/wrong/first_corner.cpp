// Diagnosis: the plane is that of the first three vertices alone
#include "polygon.hpp"

#include <algorithm>

/// The even-odd rule in the plane of the coordinates x and y of the vectors.
static bool is_inside(vec3 p, const std::vector<vec3>& vertices, int x, int y) {
  bool inside = false;
  vec3 a = vertices.back();
  for (const vec3& b : vertices) {
    if ((a[y] > p[y]) != (b[y] > p[y]) && p[x] < a[x] + (p[y] - a[y]) / (b[y] - a[y]) * (b[x] - a[x]))
      inside = !inside;
    a = b;
  }
  return inside;
}

std::optional<double> polygon(vec3 origin, vec3 direction, double t_min, double t_max,
                              const std::vector<vec3>& vertices) {
  const vec3 n = cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
  const double slope = dot(n, direction);
  if (slope == 0) return std::nullopt;
  const double t = dot(n, vertices[0] - origin) / slope;
  if (t < t_min || t > t_max) return std::nullopt;
  const vec3 size = abs(n);
  const int largest = size.z >= std::max(size.x, size.y) ? 2 : size.y >= size.x ? 1 : 0;
  if (!is_inside(origin + t * direction, vertices, (largest + 1) % 3, (largest + 2) % 3)) return std::nullopt;
  return t;
}
