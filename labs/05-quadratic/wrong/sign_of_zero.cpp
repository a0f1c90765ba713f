// Diagnosis: where b = 0 its sign is taken for 0, and with it q = -(b + sign(b)·√D) / 2: it must be 1 or -1
#include "quadratic.hpp"

#include <algorithm>

std::vector<double> quadratic(double a, double b, double c) {
  if (a == 0 && b == 0) return {};
  if (a == 0) return {-c / b};
  const double D = b * b - 4 * a * c;
  if (D < 0) return {};
  const double q = -(b + ((b > 0) - (b < 0)) * std::sqrt(D)) / 2;
  if (D == 0 || q == 0) return {q / a};
  const double x1 = q / a, x2 = c / q;
  return {std::min(x1, x2), std::max(x1, x2)};
}
