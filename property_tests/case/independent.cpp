#include "case/independent.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rayproof {
namespace {

using Vector = std::array<boost::multiprecision::cpp_int, 3>;

/// A vector times some power of two, in whole numbers: it changes a determinant's size, not whether it is 0.
Vector whole(const glm::dvec3& v) {
  constexpr int mantissa_bits = std::numeric_limits<double>::digits;
  std::array<int, 3> exponents{};
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) {
    const double fraction = std::frexp(v[static_cast<glm::length_t>(i)], &exponents[i]);
    result[i] = static_cast<std::int64_t>(std::ldexp(fraction, mantissa_bits));
  }
  const int smallest = *std::min_element(exponents.begin(), exponents.end());
  for (std::size_t i = 0; i < 3; ++i) result[i] <<= exponents[i] - smallest;
  return result;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

bool are_independent(const glm::dvec3& a, const glm::dvec3& b) {
  const Vector c = cross(whole(a), whole(b));
  return c[0] != 0 || c[1] != 0 || c[2] != 0;
}

bool are_independent(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const Vector first = whole(a);
  const Vector others = cross(whole(b), whole(c));
  return first[0] * others[0] + first[1] * others[1] + first[2] * others[2] != 0;
}

}  // namespace rayproof
