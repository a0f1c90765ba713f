#include "case/regular.hpp"

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

}  // namespace

bool is_regular(const glm::dmat4& transform) {
  std::array<std::array<Integer, 3>, 3> m;  // by columns
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4& column = transform[static_cast<glm::length_t>(i)];
    const std::array<double, 3> entries{column.x, column.y, column.z};
    // A column may be scaled by any power of two: it changes the determinant's size, not whether it is 0.
    int smallest = std::numeric_limits<int>::max();
    for (const double x : entries) {
      if (x != 0) smallest = std::min(smallest, exponent_of(x));
    }
    for (std::size_t j = 0; j < 3; ++j) {
      if (entries[j] != 0) m[i][j] = scaled(entries[j], smallest);
    }
  }
  const auto minor = [&m](std::size_t i, std::size_t j) {
    return Integer(m[1][i] * m[2][j] - m[1][j] * m[2][i]);
  };
  return m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1) != 0;
}

}  // namespace rayproof
