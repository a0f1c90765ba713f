#include "bound.hpp"

#include <cmath>

// With u = 2^-24 the products are off by at most u|ab| + u|cd|, their difference rounds by at most u(|ab| +
// |cd|) again. A factor of 4 in place of 2 covers the second-order terms and the roundings of the bound;
// 2^-148 the two underflows.
ValueAndBound bound(float a, float b, float c, float d) {
  const float p = a * b, q = c * d;
  return {p - q, 0x4p-24f * (std::abs(p) + std::abs(q)) + 0x1p-147f};
}
