#pragma once
/// \file
/// Exact fractions, vectors of them, and how a reader sees them.

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <string>
#include <vector>

#include "dossier/library.hpp"

namespace rayproof::dossier {

using Fraction = boost::multiprecision::cpp_rational;

/// Three of them.
struct FractionVector {
  Fraction x, y, z;
  [[nodiscard]] const Fraction& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

[[nodiscard]] inline FractionVector operator-(const FractionVector& a, const FractionVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline FractionVector operator+(const FractionVector& a, const FractionVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline FractionVector operator*(const Fraction& s, const FractionVector& v) {
  return {s * v.x, s * v.y, s * v.z};
}
[[nodiscard]] inline Fraction dot(const FractionVector& a, const FractionVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline FractionVector cross(const FractionVector& a, const FractionVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A t with its text: a root of a quadratic may be no fraction, and is then one within 10^-40 of it.
struct HandNumber {
  Fraction value{};  ///< within 10^-40 of what is meant
  bool is_rational = true;
};

/// The number in a few digits where that is exact, as a fraction of small numbers, or with ≈.
[[nodiscard]] std::string shown(const HandNumber& number);
[[nodiscard]] std::string shown(const Fraction& number);
[[nodiscard]] std::string shown(const FractionVector& v);

/// The root of a fraction that is not negative.
[[nodiscard]] HandNumber root_of(const Fraction& square);

/// Inputs as fractions; each throws std::runtime_error where the name is missing.
[[nodiscard]] Fraction fraction_in(const NamedNumbers& inputs, const std::string& name);
[[nodiscard]] FractionVector vector_in(const NamedNumbers& inputs, const std::string& name);
[[nodiscard]] std::vector<FractionVector> vectors_in(const NamedNumbers& inputs, const std::string& name);

}  // namespace rayproof::dossier
