#pragma once
/// \file
/// The line of a ray as two planes through it, so that a hit with r(u, v) is a root of two functions of u and
/// v alone.
///
/// Source: J. T. Kajiya, "Ray Tracing Parametric Patches", SIGGRAPH 1982.

#include <rayproof/parametric.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parametric {

/// A point of the surface as its line sees it: beside it by F and G, along it by `ahead`; t = ahead / (the
/// direction's largest component).
template <class T>
struct Seen {
  T F, G, ahead;
};

/// A ray's line, turned so that its direction is largest along `k`.
template <std::floating_point P>
struct Line {
  vec3<P> origin, direction;
  int i = 1, j = 2, k = 0;

  explicit Line(const Ray<P>& ray) : origin(ray.origin), direction(ray.direction) {
    const auto size = [&](int axis) { return abs(direction[axis]); };
    if (size(1) > size(0) && size(1) >= size(2)) k = 1;
    if (size(2) > size(0) && size(2) > size(1)) k = 2;
    i = (k + 1) % 3;
    j = (k + 2) % 3;
  }

  /// F = d_k·(r_i - o_i) - d_i·(r_k - o_k), and G the same with j: both 0 just where r is on the line.
  template <class T>
  [[nodiscard]] Seen<T> operator()(const Vec3<T>& r) const {
    const std::array<T, 3> from{r.x - T(origin.x), r.y - T(origin.y), r.z - T(origin.z)};
    const auto at = [&](int axis) -> const T& { return from[static_cast<std::size_t>(axis)]; };
    const T d_k(direction[k]);
    return {d_k * at(i) - T(direction[i]) * at(k), d_k * at(j) - T(direction[j]) * at(k), at(k)};
  }
};

/// F, G and `ahead` over a rectangle, and the derivatives of F and G by u and v.
template <class T>
struct Jet {
  Seen<T> value;
  T F_u, F_v, G_u, G_v;
};

/// The jet of any surface, by differentiation of its formula.
template <class T, class Surface, class P>
[[nodiscard]] Jet<T> jet_of(const Surface& r, const Line<P>& line, const T& u, const T& v) {
  const Seen<Dual<T>> by_u = line(r(variable(u), Dual<T>(v, T(0))));
  const Seen<Dual<T>> by_v = line(r(Dual<T>(u, T(0)), variable(v)));
  return {
      {by_u.F.value, by_u.G.value, by_u.ahead.value}, by_u.F.slope, by_v.F.slope, by_u.G.slope, by_v.G.slope};
}

}  // namespace rayproof::parametric

#include <rayproof/rounding/as_before.hpp>
