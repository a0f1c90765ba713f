#pragma once
/// \file
/// Whether a rectangle holds a root of two functions of u and v, and only one.
///
/// Source: R. Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken", 1969; its
/// proof of existence: R. E. Moore, "A Test for Existence of Solutions to Nonlinear Systems", 1977.

#include <optional>
#include <rayproof/parametric/line.hpp>

#include <rayproof/rounding/as_written.hpp>

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

/// The inverse of a Jacobian of F and G by u and v, rounded.
template <class T>
struct InverseJacobian {
  T u_F, u_G, v_F, v_G;

  /// Its rows times (F, G), in any arithmetic.
  template <class X>
  [[nodiscard]] X u(const X& F, const X& G) const {
    return X(u_F) * F + X(u_G) * G;
  }
  template <class X>
  [[nodiscard]] X v(const X& F, const X& G) const {
    return X(v_F) * F + X(v_G) * G;
  }
};

/// By Cramer's rule; nothing where there is none that is a number.
template <class T>
[[nodiscard]] std::optional<InverseJacobian<T>> inverse_of(T F_u, T F_v, T G_u, T G_v) {
  const T per = T(1) / (F_u * G_v - F_v * G_u);
  if (!(abs(per) > 0 && abs(per) < infinity<T>)) return std::nullopt;
  return InverseJacobian<T>{G_v * per, -F_v * per, -G_u * per, F_u * per};
}

/// The rounded inverse Y of the Jacobian in the middle of its bounds, and I - Y·J for all Jacobians J within
/// them.
template <class T>
struct Preconditioned {
  InverseJacobian<T> Y;
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
  const auto Y = inverse_of(jet.F_u.middle(), jet.F_v.middle(), jet.G_u.middle(), jet.G_v.middle());
  if (!Y) return std::nullopt;
  return Preconditioned<T>{*Y, I(1) - Y->u(jet.F_u, jet.G_u), -Y->u(jet.F_v, jet.G_v),
                           -Y->v(jet.F_u, jet.G_u), I(1) - Y->v(jet.F_v, jet.G_v)};
}

}  // namespace rayproof::parametric

#include <rayproof/rounding/as_before.hpp>
