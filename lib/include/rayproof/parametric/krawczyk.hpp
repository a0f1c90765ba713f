#pragma once
/// \file
/// Whether a rectangle holds a root of two functions of u and v, and only one.
///
/// Source: R. Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken", 1969; its
/// proof of existence: R. E. Moore, "A Test for Existence of Solutions to Nonlinear Systems", 1977.

#include <optional>
#include <rayproof/parametric/line.hpp>

namespace rayproof::parametric {

/// A rectangle of (u, v).
template <class T>
struct Rectangle {
  Interval<T> u, v;

  [[nodiscard]] bool is_empty() const { return u.is_empty() || v.is_empty(); }
  [[nodiscard]] bool contains(const Rectangle& other) const {
    return u.contains(other.u) && v.contains(other.v);
  }
  /// Whether it contains the other with room to spare on every side.
  [[nodiscard]] bool surrounds(const Rectangle& other) const {
    return u.lo < other.u.lo && other.u.hi < u.hi && v.lo < other.v.lo && other.v.hi < v.hi;
  }
  [[nodiscard]] static Rectangle unit() { return {Interval<T>::between(0, 1), Interval<T>::between(0, 1)}; }
};
template <class T>
[[nodiscard]] Rectangle<T> intersection(const Rectangle<T>& a, const Rectangle<T>& b) {
  return {intersection(a.u, b.u), intersection(a.v, b.v)};
}
template <class T>
[[nodiscard]] Rectangle<T> hull(const Rectangle<T>& a, const Rectangle<T>& b) {
  return {hull(a.u, b.u), hull(a.v, b.v)};
}

/// The rounded inverse Y of the Jacobian in the middle of its bounds, and I - Y·J for all Jacobians J within
/// them.
template <class T>
struct Preconditioned {
  T Y_uF, Y_uG, Y_vF, Y_vG;
  Interval<T> R_uu, R_uv, R_vu, R_vv;

  /// Two points of the rectangle can't both be roots: I - Y·J shrinks every vector, so J is never singular.
  [[nodiscard]] bool is_injective() const {
    const auto row = [](const Interval<T>& a, const Interval<T>& b) { return (abs(a) + abs(b)).hi; };
    return row(R_uu, R_uv) < 1 && row(R_vu, R_vv) < 1;
  }
};

/// Nothing where the middle Jacobian has no inverse.
template <class T>
[[nodiscard]] std::optional<Preconditioned<T>> precondition(const Jet<Interval<T>>& jet) {
  using I = Interval<T>;
  const T a = jet.F_u.middle(), b = jet.F_v.middle(), c = jet.G_u.middle(), d = jet.G_v.middle();
  const T per = T(1) / (a * d - b * c);
  if (!(abs(per) > 0 && abs(per) < infinity<T>)) return std::nullopt;
  Preconditioned<T> p{d * per, -b * per, -c * per, a * per, {}, {}, {}, {}};
  p.R_uu = I(1) - (I(p.Y_uF) * jet.F_u + I(p.Y_uG) * jet.G_u);
  p.R_uv = -(I(p.Y_uF) * jet.F_v + I(p.Y_uG) * jet.G_v);
  p.R_vu = -(I(p.Y_vF) * jet.F_u + I(p.Y_vG) * jet.G_u);
  p.R_vv = I(1) - (I(p.Y_vF) * jet.F_v + I(p.Y_vG) * jet.G_v);
  return p;
}

/// Krawczyk's image c - Y·f(c) + (I - Y·J)·(X - c) of the rectangle X with middle c: it holds every root that
/// X holds, and where X surrounds it, X holds just one.
template <class T>
[[nodiscard]] Rectangle<T> krawczyk(const Rectangle<T>& X, const Preconditioned<T>& p,
                                    const Seen<Interval<T>>& at_middle) {
  using I = Interval<T>;
  const I c_u(X.u.middle()), c_v(X.v.middle());
  const I du = X.u - c_u, dv = X.v - c_v;
  return {c_u - (I(p.Y_uF) * at_middle.F + I(p.Y_uG) * at_middle.G) + (p.R_uu * du + p.R_uv * dv),
          c_v - (I(p.Y_vF) * at_middle.F + I(p.Y_vG) * at_middle.G) + (p.R_vu * du + p.R_vv * dv)};
}

}  // namespace rayproof::parametric
