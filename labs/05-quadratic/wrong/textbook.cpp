// Diagnosis: -b ± √D cancels
#include "quadratic.hpp"

#include <algorithm>

std::vector<double> quadratic(double a, double b, double c) {
  if (a == 0 && b == 0) return {};
  if (a == 0) return {-c / b};
  const double D = b * b - 4 * a * c;
  if (D < 0) return {};
  const double x1 = (-b - std::sqrt(D)) / (2 * a), x2 = (-b + std::sqrt(D)) / (2 * a);
  if (x1 == x2) return {x1};
  return {std::min(x1, x2), std::max(x1, x2)};
}
