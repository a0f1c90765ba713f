#pragma once
/// \file
/// A root of a patch and a line found by plain Newton steps, and the proof that it is one.

#include <rayproof/parametric/krawczyk.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parametric {

/// A proven root: just one lies in `only_one`, and it lies in `root`, a part of that.
template <class T>
struct Confirmed {
  Rectangle<T> root, only_one;
};

/// A surface along a line, in plain numbers and in intervals.
template <class Surface, std::floating_point T>
struct Meeting {
  using I = Interval<T>;
  const Surface& r;
  const Line<T>& line;

  [[nodiscard]] Seen<I> seen(const I& u, const I& v) const { return line(r(u, v)); }
  [[nodiscard]] Jet<I> jet(const Rectangle<T>& X) const { return jet_of(r, line, X.u, X.v); }

  /// Krawczyk's image c - Y·f(c) + (I - Y·J)·(X - c) of the rectangle X with middle c: it holds every root
  /// that X holds, and where X surrounds it, X holds just one.
  [[nodiscard]] Rectangle<T> image_of(const Rectangle<T>& X, const Preconditioned<T>& p) const {
    const I c_u(X.u.middle()), c_v(X.v.middle());
    const I du = X.u - c_u, dv = X.v - c_v;
    const Seen<I> at_middle = seen(c_u, c_v);
    return {c_u - p.Y.u(at_middle.F, at_middle.G) + (p.R_uu * du + p.R_uv * dv),
            c_v - p.Y.v(at_middle.F, at_middle.G) + (p.R_vu * du + p.R_vv * dv)};
  }

  /// Whether the functions are one to one over a rectangle, which then holds one root at most.
  [[nodiscard]] bool is_injective(const Rectangle<T>& X) const {
    const auto p = precondition(jet(X));
    return p && p->is_injective();
  }

  /// A few plain Newton steps; the last (u, v) before they leave the numbers.
  [[nodiscard]] std::pair<T, T> polished(T u, T v) const {
    for (int step = 0; step < 8; ++step) {
      const Jet<T> at = jet_of(r, line, u, v);
      const auto Y = inverse_of(at.F_u, at.F_v, at.G_u, at.G_v);
      if (!Y) break;
      const T u_next = u - Y->u(at.value.F, at.value.G);
      const T v_next = v - Y->v(at.value.F, at.value.G);
      if (!(abs(u_next) < 4 && abs(v_next) < 4) || (u_next == u && v_next == v)) break;
      u = u_next;
      v = v_next;
    }
    return {u, v};
  }

  /// Rectangles about a polished root, each larger than the one before, until Krawczyk's test proves one.
  [[nodiscard]] std::optional<Confirmed<T>> confirmed(T u, T v) const {
    for (T reach = 16 * std::numeric_limits<T>::epsilon(); reach < T(0.01); reach *= 16) {
      const Rectangle<T> X{I::between(u - reach, u + reach), I::between(v - reach, v + reach)};
      const auto p = precondition(jet(X));
      if (!p) return std::nullopt;
      const Rectangle<T> image = image_of(X, *p);
      if (p->is_injective() && X.surrounds(image)) return Confirmed<T>{image, X};
    }
    return std::nullopt;
  }
};

}  // namespace rayproof::parametric

#include <rayproof/rounding/as_before.hpp>
