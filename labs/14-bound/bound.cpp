#include "bound.hpp"

/// a·b - c·d, computed in float, and a bound of its error: |value - exact| <= bound, always.
ValueAndBound bound(float a, float b, float c, float d) {
  return {a * b - c * d, 0};  // your bound
}
