#include "quadratic.hpp"

/// The real roots of a x² + b x + c = 0, ascending: two, one or none. a may be 0.
std::vector<double> quadratic(double /*a*/, double /*b*/, double /*c*/) {
  return {};  // your formula
}
