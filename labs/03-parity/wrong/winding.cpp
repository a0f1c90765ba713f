// Diagnosis: the non-zero winding rule
#include "parity.hpp"

bool parity(vec2 point, const std::vector<vec2>& vertices) {
  int winding = 0;
  vec2 p = vertices.back();
  for (const vec2 q : vertices) {
    const double side = (q.x - p.x) * (point.y - p.y) - (q.y - p.y) * (point.x - p.x);
    if (p.y <= point.y && q.y > point.y && side > 0) ++winding;
    if (p.y > point.y && q.y <= point.y && side < 0) --winding;
    p = q;
  }
  return winding != 0;
}
