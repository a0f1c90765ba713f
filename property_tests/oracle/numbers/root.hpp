#pragma once
/// \file
/// The real roots of an exact quadratic as exact numbers: compared, estimated and rounded without error.

#include <array>
#include <boost/container/static_vector.hpp>
#include <rayproof/quadratic.hpp>
#include <utility>

#include "case/case.hpp"
#include "oracle/numbers/quotient.hpp"

namespace rayproof::oracle {

/// a·x² + 2·h·x + c with a > 0, over the exact ring.
struct ExactQuadratic {
  Ring a, h, c;

  /// A quarter of the discriminant.
  [[nodiscard]] Ring discriminant() const { return h * h - a * c; }

  /// The quadratic whose roots are those of this one less x: half its slope and its value at x.
  [[nodiscard]] ExactQuadratic seen_from(const Ring& x) const {
    const Ring slope = a * x + h;
    return {a, slope, (slope + h) * x + c};
  }
};

/// The sign of (root - x) for the root on `side` of a quadratic with a > 0, from the signs of its value and
/// slope at x.
[[nodiscard]] constexpr int compare_root(int side, int value, int slope) {
  if (value < 0) return side;                // x lies between the two roots
  if (value > 0) return slope > 0 ? -1 : 1;  // x lies outside, on the slope's side
  return slope * side >= 0 ? 0 : side;       // x is a root: this one, or the other
}

/// One real root of a quadratic whose discriminant is not negative: the lower (side = -1) or the upper (side
/// = 1).
class ExactRoot {
 public:
  ExactRoot(ExactQuadratic quadratic, int side) : quadratic_(std::move(quadratic)), side_(side) {}

  /// The sign of (root - x), exactly.
  [[nodiscard]] int compare(const Ring& x) const {
    const auto [a, slope, value] = quadratic_.seen_from(x);
    return compare_root(side_, sign(value), sign(slope));
  }

  /// root - x, an error, to one part in 2^28, however near they are: the difference is itself a root.
  [[nodiscard]] Scaled minus(double x) const {
    return ExactRoot(quadratic_.seen_from(Ring(x)), side_).estimated(roughly);
  }

  /// The root to one part in 2^58.
  [[nodiscard]] Scaled estimate() const {
    return estimated([](const Ring& c) { return approximate(c); });
  }

  /// offset + slope·root, as a root itself: of the quadratic that (X - offset)/slope solves. With slope 0 it
  /// has the double root `offset`.
  [[nodiscard]] ExactRoot affine_image(const Ring& offset, const Ring& slope) const {
    const auto& [a, h, c] = quadratic_;
    const Ring hs = h * slope;
    const Ring ao = a * offset;
    const ExactQuadratic image{a, hs - ao, (ao - hs - hs) * offset + c * slope * slope};
    return {image, sign(slope) < 0 ? -side_ : side_};
  }

 private:
  /// By the branches that do not cancel; c, which is small beside an x that is nearly a root, is read by
  /// read_c.
  template <class ReadC>
  [[nodiscard]] Scaled estimated(const ReadC& read_c) const {
    const Scaled s = sqrt(approximate(quadratic_.discriminant()));
    const Scaled h = approximate(quadratic_.h);
    const Scaled size = abs(h) + s;
    const Scaled q = h.sign() > 0 ? -size : size;
    const bool adds_up = side_ == (h.sign() > 0 ? -1 : 1);
    return adds_up || q.sign() == 0 ? q / approximate(quadratic_.a) : read_c(quadratic_.c) / q;
  }

  ExactQuadratic quadratic_;
  int side_;
};

/// The number rounded to nearest, ties to even, in the case's precision; infinite where it overflows.
template <class Number>
[[nodiscard]] double round_correctly(const Number& number, Precision precision);
extern template double round_correctly(const ExactRoot&, Precision);
extern template double round_correctly(const Quotient&, Precision);

/// The real roots, ascending, a double one once.
using RootList = boost::container::static_vector<ExactRoot, 2>;
[[nodiscard]] inline RootList real_roots(const ExactQuadratic& quadratic) {
  const int discriminant = sign(quadratic.discriminant());
  RootList roots;
  if (discriminant >= 0) roots.emplace_back(quadratic, -1);
  if (discriminant > 0) roots.emplace_back(quadratic, 1);
  return roots;
}

/// What an equation a·x² + 2·h·x + c = 0 comes to, whatever its coefficients.
struct SolvedEquation {
  RootKind kind = RootKind::none;
  RootList roots{};
};

[[nodiscard]] inline SolvedEquation solve(const Ring& a, const Ring& h, const Ring& c) {
  const int opening = sign(a);
  if (opening == 0) {
    if (sign(h) == 0) return {sign(c) == 0 ? RootKind::everything : RootKind::constant};
    const Ring b = h + h;  // the square of 2·h·x + c has its root as a double one
    return {RootKind::linear, real_roots({b * b, b * c, c * c})};
  }
  RootList roots = real_roots(opening > 0 ? ExactQuadratic{a, h, c} : ExactQuadratic{-a, -h, -c});
  constexpr std::array kinds{RootKind::none, RootKind::twice, RootKind::two};
  return {kinds.at(roots.size()), std::move(roots)};
}

}  // namespace rayproof::oracle
