#include "case/independent.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rayproof {
namespace {

using Integer = boost::multiprecision::cpp_int;

constexpr int mantissa_bits = std::numeric_limits<double>::digits;

int exponent_of(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent;
}

/// x · 2^(mantissa_bits - exponent), a whole number for every x with an exponent of at least `exponent`.
Integer scaled(double x, int exponent) {
  int own = 0;
  const double fraction = std::frexp(x, &own);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, mantissa_bits));
  return mantissa * pow(Integer(2), static_cast<unsigned>(own - exponent));
}

using Vector = std::array<Integer, 3>;

/// A vector times some power of two, in whole numbers: it changes a determinant's size, not whether it is 0.
Vector whole(const glm::dvec3& v) {
  const std::array<double, 3> entries{v.x, v.y, v.z};
  int smallest = std::numeric_limits<int>::max();
  for (const double x : entries) {
    if (x != 0) smallest = std::min(smallest, exponent_of(x));
  }
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (entries[i] != 0) result[i] = scaled(entries[i], smallest);
  }
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
