#include "watertight.hpp"

std::optional<double> watertight(vec3 origin, vec3 direction, double t_min, double t_max, vec3 a, vec3 b,
                                 vec3 c) {
  const vec3 size = abs(direction);
  const int z = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const auto seen = [&](vec3 corner) {  // along the ray: at (0, 0), at the height t
    const vec3 v = corner - origin;
    const double t = v[z] / direction[z];
    return vec3(v[x] - t * direction[x], v[y] - t * direction[y], t);
  };
  const auto side = [](vec3 p, vec3 q) { return p.x * q.y - p.y * q.x; };
  const vec3 A = seen(a), B = seen(b), C = seen(c);
  const double u = side(B, C), v = side(C, A), w = side(A, B);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double sum = u + v + w;
  if (sum == 0) return std::nullopt;
  const double t = (u * A.z + v * B.z + w * C.z) / sum;
  if (t < t_min || t > t_max) return std::nullopt;
  return t;
}
