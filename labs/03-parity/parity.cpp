#include "parity.hpp"

/// Whether the point is inside the polygon by the even-odd rule. The last vertex is joined to the first.
bool parity(vec2 /*point*/, const std::vector<vec2>& /*vertices*/) {
  return false;  // your rule
}
