#pragma once
/// \file
/// A rectangle of a surface that a search cuts in two: bounds of the surface over it, and its halves.

#include <rayproof/parametric/bezier.hpp>
#include <utility>

namespace rayproof::parametric {

/// Where a rectangle is cut: across its longer side. The ends are whole multiples of powers of two, and so
/// exact.
template <class P>
[[nodiscard]] bool is_longer_in_u(const Interval<P>& u, const Interval<P>& v) {
  return u.hi - u.lo >= v.hi - v.lo;
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
    if (is_longer_in_u(u, v)) {
      both.first.u.hi = both.second.u.lo = u.middle();
    } else {
      both.first.v.hi = both.second.v.lo = v.middle();
    }
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
    return {{hull_of(F), hull_of(G), hull_of(ahead)}, slope_u(F), slope_v(F), slope_u(G), slope_v(G)};
  }

  [[nodiscard]] std::pair<Piece, Piece> halves() const {
    std::pair<Piece, Piece> both{*this, *this};
    Piece& lower = both.first;
    Piece& upper = both.second;
    if (is_longer_in_u(u, v)) {
      lower.u.hi = upper.u.lo = u.middle();
      for (Net Piece::*const net : {&Piece::F, &Piece::G, &Piece::ahead})
        for (std::size_t j = 0; j <= Degree; ++j)
          halve([&](std::size_t i) -> I& { return (lower.*net)[i][j]; },
                [&](std::size_t i) -> I& { return (upper.*net)[i][j]; });
    } else {
      lower.v.hi = upper.v.lo = v.middle();
      for (Net Piece::*const net : {&Piece::F, &Piece::G, &Piece::ahead})
        for (std::size_t i = 0; i <= Degree; ++i)
          halve([&](std::size_t j) -> I& { return (lower.*net)[i][j]; },
                [&](std::size_t j) -> I& { return (upper.*net)[i][j]; });
    }
    return both;
  }

 private:
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
  [[nodiscard]] I slope_u(const Net& net) const {
    I all = net[1][0] - net[0][0];
    for (std::size_t i = 0; i < Degree; ++i)
      for (std::size_t j = 0; j <= Degree; ++j) all = hull(all, net[i + 1][j] - net[i][j]);
    return I(Degree) * all / I(u.hi - u.lo);
  }
  [[nodiscard]] I slope_v(const Net& net) const {
    I all = net[0][1] - net[0][0];
    for (std::size_t i = 0; i <= Degree; ++i)
      for (std::size_t j = 0; j < Degree; ++j) all = hull(all, net[i][j + 1] - net[i][j]);
    return I(Degree) * all / I(v.hi - v.lo);
  }
};

}  // namespace rayproof::parametric
