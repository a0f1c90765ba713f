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

/// a·x² + 2·h·x + c with a > 0.
template <class R>
struct QuadraticOver {
  R a, h, c;

  /// A quarter of the discriminant.
  [[nodiscard]] R discriminant() const { return h * h - a * c; }

  /// The quadratic whose roots are those of this one less x: half its slope and its value at x.
  [[nodiscard]] QuadraticOver seen_from(const R& x) const {
    const R slope = a * x + h;
    return {a, slope, (slope + h) * x + c};
  }
};
using ExactQuadratic = QuadraticOver<Ring>;

/// The sign of (root - x) for the root on `side` of a quadratic with a > 0, from the signs of its value and
/// slope at x.
[[nodiscard]] constexpr int compare_root(int side, int value, int slope) {
  if (value < 0) return side;                // x lies between the two roots
  if (value > 0) return slope > 0 ? -1 : 1;  // x lies outside, on the slope's side
  return slope * side >= 0 ? 0 : side;       // x is a root: this one, or the other
}

/// One real root of a quadratic whose discriminant is not negative: the lower (side = -1) or the upper (side
/// = 1).
template <class R>
class RootOf {
 public:
  using Over = R;

  RootOf(QuadraticOver<R> quadratic, int side) : quadratic_(std::move(quadratic)), side_(side) {}

  /// The sign of (root - x), exactly.
  [[nodiscard]] int compare(const R& x) const {
    const auto [a, slope, value] = quadratic_.seen_from(x);
    return compare_root(side_, sign(value), sign(slope));
  }

  /// root - x, an error, to one part in 2^28, however near they are: the difference is itself a root.
  [[nodiscard]] SizeOf<R> minus(double x) const {
    return RootOf(quadratic_.seen_from(R(x)), side_).estimated([](const R& c) { return roughly(c); });
  }

  /// The root to one part in 2^58.
  [[nodiscard]] SizeOf<R> estimate() const {
    return estimated([](const R& c) { return approximate(c); });
  }

  /// offset + slope·root, as a root itself: of the quadratic that (X - offset)/slope solves. With slope 0 it
  /// has the double root `offset`.
  [[nodiscard]] RootOf affine_image(const R& offset, const R& slope) const {
    const auto& [a, h, c] = quadratic_;
    const R hs = h * slope;
    const R ao = a * offset;
    const QuadraticOver<R> image{a, hs - ao, (ao - hs - hs) * offset + c * slope * slope};
    return {image, sign(slope) < 0 ? -side_ : side_};
  }

 private:
  /// By the branches that do not cancel; c, which is small beside an x that is nearly a root, is read by
  /// read_c.
  template <class ReadC>
  [[nodiscard]] SizeOf<R> estimated(const ReadC& read_c) const {
    using std::abs, std::sqrt;
    using Size = SizeOf<R>;
    const Size s = sqrt(approximate(quadratic_.discriminant()));
    const Size h = approximate(quadratic_.h);
    const Size size = abs(h) + s;
    const Size q = sign(h) > 0 ? -size : size;
    const bool adds_up = side_ == (sign(h) > 0 ? -1 : 1);
    return adds_up || sign(q) == 0 ? q / approximate(quadratic_.a) : read_c(quadratic_.c) / q;
  }

  QuadraticOver<R> quadratic_;
  int side_;
};
using ExactRoot = RootOf<Ring>;

/// The number rounded to nearest, ties to even, in the case's precision; infinite where it overflows.
template <class Number>
[[nodiscard]] double round_correctly(const Number& number, Precision precision);
extern template double round_correctly(const ExactRoot&, Precision);
extern template double round_correctly(const Quotient&, Precision);
extern template double round_correctly(const RootOf<Estimate>&, Precision);
extern template double round_correctly(const QuotientOf<Estimate>&, Precision);

/// The real roots, ascending, a double one once.
template <class R>
using RootsOf = boost::container::static_vector<RootOf<R>, 2>;
using RootList = RootsOf<Ring>;
template <class R>
[[nodiscard]] RootsOf<R> real_roots(const QuadraticOver<R>& quadratic) {
  const int discriminant = sign(quadratic.discriminant());
  RootsOf<R> roots;
  if (discriminant >= 0) roots.emplace_back(quadratic, -1);
  if (discriminant > 0) roots.emplace_back(quadratic, 1);
  return roots;
}

/// What an equation a·x² + 2·h·x + c = 0 comes to, whatever its coefficients.
template <class R>
struct Solved {
  RootKind kind = RootKind::none;
  RootsOf<R> roots{};
};
using SolvedEquation = Solved<Ring>;

template <class R>
[[nodiscard]] Solved<R> solve(const R& a, const R& h, const R& c) {
  const int opening = sign(a);
  if (opening == 0) {
    if (sign(h) == 0) return {sign(c) == 0 ? RootKind::everything : RootKind::constant};
    const R b = h + h;  // the square of 2·h·x + c has its root as a double one
    return {RootKind::linear, real_roots(QuadraticOver<R>{b * b, b * c, c * c})};
  }
  RootsOf<R> roots = real_roots(opening > 0 ? QuadraticOver<R>{a, h, c} : QuadraticOver<R>{-a, -h, -c});
  constexpr std::array kinds{RootKind::none, RootKind::twice, RootKind::two};
  return {kinds.at(roots.size()), std::move(roots)};
}

}  // namespace rayproof::oracle
