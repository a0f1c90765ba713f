// Diagnosis: inside is called outside
#include "parity.hpp"

bool parity(vec2 point, const std::vector<vec2>& vertices) {
  bool is_inside = false;
  vec2 p = vertices.back();
  for (const vec2 q : vertices) {
    if ((p.y > point.y) != (q.y > point.y)) {
      const double x = p.x + (point.y - p.y) / (q.y - p.y) * (q.x - p.x);
      if (point.x < x) is_inside = !is_inside;
    }
    p = q;
  }
  return !is_inside;
}
