#pragma once
/// \file
/// A rectangle of a surface that a search cuts in two: bounds of the surface over it, and its halves.

#include <rayproof/parametric/bezier.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parametric {

/// Leaves to two copies of a piece a half each, cut across the longer side; whether that is u. The ends are
/// whole multiples of powers of two, and so exact.
template <class Piece>
bool share_out(Piece& lower, Piece& upper) {
  const bool is_u = lower.u.hi - lower.u.lo >= lower.v.hi - lower.v.lo;
  auto Piece::*const side = is_u ? &Piece::u : &Piece::v;
  (upper.*side).lo = (lower.*side).middle();
  (lower.*side).hi = (upper.*side).lo;
  return is_u;
}

/// Any surface: the bounds are what its formula gives in interval arithmetic.
template <class Surface, std::floating_point P>
struct Piece {
  const Surface* r;
  const Line<P>* line;
  Interval<P> u = Interval<P>::between(0, 1);
  Interval<P> v = Interval<P>::between(0, 1);

  Piece(const Surface& surface, const Line<P>& along) : r(&surface), line(&along) {}

  [[nodiscard]] Jet<Interval<P>> bounds() const { return jet_of(*r, *line, u, v); }

  [[nodiscard]] std::pair<Piece, Piece> halves() const {
    std::pair<Piece, Piece> both{*this, *this};
    share_out(both.first, both.second);
    return both;
  }
};

/// A Bézier patch: its control points as the line sees them, cut by de Casteljau's algorithm. The surface
/// lies in their hull, the derivatives in the hull of their differences.
template <std::floating_point P, std::size_t Degree>
struct Piece<BezierPatch<P, Degree>, P> {
  using I = Interval<P>;
  using Net = std::array<std::array<I, Degree + 1>, Degree + 1>;

  Net F, G, ahead;
  I u = I::between(0, 1);
  I v = I::between(0, 1);

  Piece(const BezierPatch<P, Degree>& patch, const Line<P>& line) {
    for (std::size_t i = 0; i <= Degree; ++i) {
      for (std::size_t j = 0; j <= Degree; ++j) {
        const Seen<I> seen = line(Vec3<I>(convert<I>(patch.points[i][j])));
        F[i][j] = seen.F;
        G[i][j] = seen.G;
        ahead[i][j] = seen.ahead;
      }
    }
  }

  [[nodiscard]] Jet<I> bounds() const {
    return {{hull_of(F), hull_of(G), hull_of(ahead)},
            slope(F, true),
            slope(F, false),
            slope(G, true),
            slope(G, false)};
  }

  [[nodiscard]] std::pair<Piece, Piece> halves() const {
    std::pair<Piece, Piece> both{*this, *this};
    const bool in_u = share_out(both.first, both.second);
    for (Net Piece::*const net : {&Piece::F, &Piece::G, &Piece::ahead})
      for (std::size_t k = 0; k <= Degree; ++k)
        halve(row_of(both.first.*net, in_u, k), row_of(both.second.*net, in_u, k));
    return both;
  }

 private:
  /// The k-th row of a net along u or v, as a function of the place in it.
  template <class AnyNet>
  static auto row_of(AnyNet& net, bool in_u, std::size_t k) {
    return [&net, in_u, k ](std::size_t i) -> auto& { return in_u ? net[i][k] : net[k][i]; };
  }
  /// De Casteljau at 1/2: the first points of each round make the lower half, what is left the upper one.
  template <class Lower, class Upper>
  static void halve(Lower&& lower, Upper&& upper) {
    for (std::size_t round = 1; round <= Degree; ++round) {
      for (std::size_t i = 0; i + round <= Degree; ++i) upper(i) = I(P(0.5)) * (upper(i) + upper(i + 1));
      lower(round) = upper(0);
    }
  }
  static I hull_of(const Net& net) {
    I all = net[0][0];
    for (const auto& row : net) {
      for (const I& b : row) {
        if (b.is_empty()) return b;  // a NaN is nowhere
        all = hull(all, b);
      }
    }
    return all;
  }
  /// Bounds of the derivative along u or v: Degree times the differences of neighbours.
  [[nodiscard]] I slope(const Net& net, bool in_u) const {
    I all = I::empty();
    for (std::size_t k = 0; k <= Degree; ++k) {
      const auto b = row_of(net, in_u, k);
      for (std::size_t i = 0; i < Degree; ++i) all = hull(all, b(i + 1) - b(i));
    }
    const I& side = in_u ? u : v;
    return I(static_cast<int>(Degree)) * all / I(side.hi - side.lo);
  }
};

}  // namespace rayproof::parametric

#include <rayproof/rounding/as_before.hpp>
