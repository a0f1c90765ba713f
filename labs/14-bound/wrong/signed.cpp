// Diagnosis: take absolute values
#include "bound.hpp"

#include <cmath>
#include <limits>

ValueAndBound bound(float a, float b, float c, float d) {
  return {a * b - c * d, 0x4p-24f * (a * b + c * d)};
}
