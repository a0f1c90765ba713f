#pragma once
/// \file
/// The roots of a quadratic whose coefficients are exact: compared without rounding, and rounded once.

#include <rayproof/formulas/exact_rounding.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The sign of (root - x) for the lower (side = -1) or upper (side = 1) root of a quadratic that opens
/// upwards, from the signs of its value and of its slope at x.
[[nodiscard]] constexpr int compare_root(int side, int value, int slope) {
  if (value > 0) return slope > 0 ? -1 : 1;  // outside the roots: both lie on one side of x
  if (value < 0) return side;                // between the roots
  return slope * side >= 0 ? 0 : side;       // x is a root: this one, or the other
}

/// a·t² - 2·b·t + c with a > 0 and b² >= a·c, in exact expansions. Its lower root is that of side = -1, its
/// upper one that of side = 1.
template <class A, class B, class C>
struct ExpandedQuadratic {
  A a;
  B b;
  C c;
  double half_chord;  ///< √(b² - a·c): what a·t - b comes to at the upper root, rounded
  std::array<double, 2> approximate_roots;  ///< to within 2^-49 of their size

  [[nodiscard]] double approximate(int side) const { return approximate_roots[side < 0 ? 0 : 1]; }

  /// The exact sign of (root - t).
  template <std::size_t K>
  [[nodiscard]] int compare(int side, const Expansion<double, K>& t) const {
    return compare_root(side, sign(at(t)), sign(slope_at(t)));
  }
  /// The exact sign of (root - n/m).
  template <class Numerator, class Denominator>
  [[nodiscard]] int compare(int side, const ExactRatio<Numerator, Denominator>& ratio) const {
    const auto& n = ratio.numerator;
    const auto& m = ratio.denominator;
    const int value = sign(a * (n * n) - exact(2.0) * b * (n * m) + c * (m * m));
    return compare_root(side, value, sign(a * n - b * m) * sign(m));
  }

  /// A root in T, rounded once, on its own side of the ends of the ray's interval.
  template <class T>
  [[nodiscard]] T root(const Ray<T>& ray, int side) const {
    double t = approximate(side);
    if (sizeof(T) == sizeof(double) && abs(t) < infinity<double>) {
      // From outside of both roots, where slope and half chord have one sign: however near to each other the
      // roots are, their sum does not cancel.
      t += side * 0x1p-48 * abs(t);
      // Less the exact value there over the exact slope between t and the root: this rounds once.
      const double slope = estimate(slope_at(exact(t))) + side * half_chord;
      if (slope != 0) t -= estimate(at(exact(t))) / slope;
    }
    return rounded(ray, t, [&](const auto& x) { return compare(side, x); });
  }

 private:
  template <std::size_t K>
  [[nodiscard]] auto at(const Expansion<double, K>& t) const {
    return (a * t - exact(2.0) * b) * t + c;
  }
  template <std::size_t K>
  [[nodiscard]] auto slope_at(const Expansion<double, K>& t) const {
    return a * t - b;
  }
};

template <class A, class B, class C>
ExpandedQuadratic(A, B, C, double, std::array<double, 2>) -> ExpandedQuadratic<A, B, C>;

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
