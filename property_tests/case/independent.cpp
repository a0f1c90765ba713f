#include "case/independent.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <initializer_list>
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

/// A sum of at most six products of two or three numbers in doubles, and the sum of their sizes.
struct RoundedSum {
  double sum = 0, size = 0;

  void add(double product) {
    sum += product;
    size += std::abs(product);
  }
  /// Whether the exact sum is not 0, for certain: a product is off by two roundings of 2^-53 at most, the
  /// sums by six; and what underflow takes from products of numbers that are no larger than 2^300 is far
  /// less.
  [[nodiscard]] bool is_not_0() const { return size > 0x1p-700 && std::abs(sum) > 0x1p-48 * size; }
};

bool are_moderate(std::initializer_list<glm::dvec3> vectors) {
  return std::ranges::all_of(vectors, [](const glm::dvec3& v) {
    return std::abs(v.x) <= 0x1p300 && std::abs(v.y) <= 0x1p300 && std::abs(v.z) <= 0x1p300;
  });
}

/// Whether doubles are enough to know that a × b is not zero.
bool are_surely_independent(const glm::dvec3& a, const glm::dvec3& b) {
  if (!are_moderate({a, b})) return false;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    RoundedSum component;
    component.add(a[j] * b[k]);
    component.add(-a[k] * b[j]);
    if (component.is_not_0()) return true;
  }
  return false;
}

/// The same of the determinant.
bool are_surely_independent(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  if (!are_moderate({a, b, c})) return false;
  RoundedSum determinant;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    determinant.add(a[i] * b[j] * c[k]);
    determinant.add(-a[i] * b[k] * c[j]);
  }
  return determinant.is_not_0();
}

}  // namespace

bool are_independent(const glm::dvec3& a, const glm::dvec3& b) {
  if (are_surely_independent(a, b)) return true;
  const Vector c = cross(whole(a), whole(b));
  return c[0] != 0 || c[1] != 0 || c[2] != 0;
}

bool are_independent(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  if (are_surely_independent(a, b, c)) return true;
  const Vector first = whole(a);
  const Vector others = cross(whole(b), whole(c));
  return first[0] * others[0] + first[1] * others[1] + first[2] * others[2] != 0;
}

}  // namespace rayproof
