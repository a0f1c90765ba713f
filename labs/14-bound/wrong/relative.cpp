// Diagnosis: the bound is relative to the result
#include "bound.hpp"

#include <cmath>
#include <limits>

ValueAndBound bound(float a, float b, float c, float d) {
  const float value = a * b - c * d;
  return {value, 4 * 0x1p-24f * std::abs(value) + 0x1p-147f};
}
