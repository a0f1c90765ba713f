// Diagnosis: the epsilon of double
#include "bound.hpp"

#include <cmath>
#include <limits>

ValueAndBound bound(float a, float b, float c, float d) {
  const float p = a * b, q = c * d;
  return {p - q,
          4 * static_cast<float>(std::numeric_limits<double>::epsilon()) * (std::abs(p) + std::abs(q)) +
              0x1p-147f};
}
