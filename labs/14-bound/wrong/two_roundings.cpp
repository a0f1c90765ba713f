// Diagnosis: a rounding is forgotten
#include "bound.hpp"

#include <cmath>
#include <limits>

ValueAndBound bound(float a, float b, float c, float d) {
  const float p = a * b, q = c * d;
  return {p - q, 0x1p-24f * (std::abs(p) + std::abs(q)) + 0x1p-147f};
}
