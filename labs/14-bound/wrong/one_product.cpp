// Diagnosis: only a·b is in the bound
#include "bound.hpp"

#include <cmath>
#include <limits>

ValueAndBound bound(float a, float b, float c, float d) {
  return {a * b - c * d, 16 * 0x1p-24f * std::abs(a * b)};
}
