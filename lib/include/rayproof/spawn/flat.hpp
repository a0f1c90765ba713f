#pragma once
/// \file
/// Leaving a plane, a triangle or a polygon: all are left as planes, in one form that is made once for each.

#include <rayproof/arithmetics/error_free.hpp>
#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/plane.hpp>
#include <rayproof/polygon.hpp>
#include <rayproof/spawn/surface_point.hpp>
#include <rayproof/transform.hpp>
#include <rayproof/triangle.hpp>

namespace rayproof::spawn {

/// A plane through `anchor`, or no further than `slack` from it; |normal - N| <= tilt for the exact unit
/// normal N.
template <class T>
struct Flat {
  vec3<T> anchor;
  vec3<T> normal;
  T tilt;
  T slack;
};

/// The same plane in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Flat<To> convert(const Flat<From>& flat) {
  return {convert<To>(flat.anchor), convert<To>(flat.normal), To(flat.tilt), To(flat.slack)};
}

/// The point moved along the normal onto the plane.
///
/// With f = p - anchor, rounded in each component, the height s = normal·f is off by 5ε·Σ|nᵢfᵢ| and by
/// tilt·|f|; moving by s leaves tilt·|s| + 3ε|s| more, along N; and the sum is rounded.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Flat<T>& flat, const vec3<T>& p,
                                                      const vec3<T>& /*resolution*/) {
  constexpr auto eps = unit<T>;
  const vec3<T>& n = flat.normal;
  const vec3<T> sizes = magnitudes<T>(n);
  const vec3<T> f = p - flat.anchor, spread = magnitudes<T>(f);
  const T height = dot(n, f);
  const vec3<T> moved = height * n;
  const vec3<T> point = p - moved;
  const T along = T(5 * eps) * dot(sizes, spread) + flat.tilt * sum<T>(spread) + flat.slack +
                  (T(3 * eps) + flat.tilt) * abs(height);
  const auto error = [&](const T& size, const T& at, const T& by) {
    return (size + flat.tilt) * along + T(eps) * (abs(at) + T(2) * abs(by));
  };
  return {p,
          point,
          n,
          n,
          vec3<T>{error(sizes.x, point.x, moved.x), error(sizes.y, point.y, moved.y),
                  error(sizes.z, point.z, moved.z)},
          flat.tilt,
          T(0)};
}

/// A plane has no edges to stay away from.
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Flat<T>& /*flat*/) {
  return vec3<T>{T(0), T(0), T(0)};
}

namespace detail {

/// Sums of products in twice the digits (T. Ogita, S. M. Rump, S. Oishi, "Accurate Sum and Dot Product",
/// 2005, algorithm Dot2): `value()` is off by 2ε of itself and by 4(n+2)ε² of `size`, the sum of the n
/// magnitudes.
template <std::floating_point T>
struct LongSum {
  T high = 0, low = 0, size = 0;
  int terms = 0;

  void add_product(T a, T b) {
    const ErrorFree<T> product = two_product(a, b), total = two_sum(high, product.rounded);
    high = total.rounded;
    low += total.rest + product.rest;
    size += abs(product.rounded);
    ++terms;
  }
  [[nodiscard]] T value() const { return high + low; }
  [[nodiscard]] T bound() const {
    return 4 * T(terms + 2) * unit<T> * unit<T> * size + 2 * unit<T> * abs(value());
  }
};

/// b - a in each component, exactly: the difference as rounded, and what was rounded away.
template <std::floating_point T>
struct ExactDifference {
  vec3<T> high, low;

  ExactDifference(const vec3<T>& b, const vec3<T>& a) {
    for (int i = 0; i < 3; ++i) {
      const ErrorFree<T> difference = two_sum(b[i], -a[i]);
      high[i] = difference.rounded;
      low[i] = difference.rest;
    }
  }
};

/// Σ aₖ×bₖ.
template <std::floating_point T>
struct LongNormal {
  LongSum<T> axis[3];

  void add_cross(const ExactDifference<T>& a, const ExactDifference<T>& b) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      for (const auto& [x, y] : {std::pair{&a.high, &b.high}, std::pair{&a.high, &b.low},
                                 std::pair{&a.low, &b.high}, std::pair{&a.low, &b.low}}) {
        axis[i].add_product((*x)[j], (*y)[k]);
        axis[i].add_product(-(*x)[k], (*y)[j]);
      }
    }
  }

  [[nodiscard]] vec3<T> value() const { return {axis[0].value(), axis[1].value(), axis[2].value()}; }
  /// Whether each component is good to 4ε of the whole.
  [[nodiscard]] bool is_clear() const {
    const vec3<T> n = value();
    return axis[0].bound() + axis[1].bound() + axis[2].bound() <= 4 * unit<T> * sqrt(dot(n, n));
  }
};

/// Twice the vector area of closed polygons: by sums in twice the digits, or, where the vertices are so
/// nearly in a line that these do not suffice, exactly.
template <std::floating_point T>
[[nodiscard]] vec3<T> area_vector(const std::vector<vec3<T>>& vertices) {
  const vec3<T>& v0 = vertices.front();
  LongNormal<T> normal;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
    normal.add_cross({vertices[i], v0}, {vertices[i + 1], v0});
  if (normal.is_clear()) return normal.value();
  using Exact = GrowingExpansion<double>;
  std::vector<Vec3<Exact>> exact;
  for (const vec3<T>& v : vertices) exact.push_back(convert<Exact>(v));
  const Vec3<Exact> n = polygon::newell_normal<Exact>(exact, exact.front());
  const auto nearest = [](const Exact& x) { return estimate(compressed<24>(x)); };
  const glm::dvec3 wide{nearest(n.x), nearest(n.y), nearest(n.z)};
  return convert<T>(1 / sqrt(dot(wide, wide)) * wide);
}

/// Within 8ε of the exact unit normal n/|n| of a plane through the anchor.
template <std::floating_point T>
[[nodiscard]] Flat<T> plane_through(const vec3<T>& anchor, const vec3<T>& n) {
  const T length = sqrt(dot(n, n));
  return {anchor, vec3<T>{n.x / length, n.y / length, n.z / length}, 8 * unit<T>, T(0)};
}

}  // namespace detail

/// By the given normal, or u × v within 1.5 ulp. Seen from its given point, or, where that is far away beside
/// the plane's distance from (0, 0, 0), from the point nearest to (0, 0, 0), so that what is near there keeps
/// its digits: n·point is then formed exactly, and the anchor is within 6ε of its distance.
template <std::floating_point T>
[[nodiscard]] Flat<T> flat_of(const Plane<T>& plane) {
  const bool is_parametric = plane.form == PlaneForm::parametric;
  const vec3<T> n = is_parametric ? cross_compensated<T>(plane.u, plane.v) : plane.normal;
  Flat<T> flat = detail::plane_through<T>(plane.point, n);
  const T per_squared = T(1) / dot(n, n);
  const auto foot = [&](T offset) { return (offset * per_squared) * n; };
  T offset = -plane.d;
  if (plane.form != PlaneForm::implicit) {
    const T far = sum<T>(magnitudes<T>(plane.point));
    if (far <= 4 * sum<T>(magnitudes<T>(foot(dot(n, plane.point))))) return flat;
    using Exact = GrowingExpansion<double>;
    const auto exact = [](const vec3<T>& v) { return convert<Exact>(v); };
    const Vec3<Exact> normal = is_parametric ? cross(exact(plane.u), exact(plane.v)) : exact(n);
    offset = static_cast<T>(estimate(compressed<24>(dot(normal, exact(plane.point)))));
  }
  flat.anchor = foot(offset);
  flat.slack = 6 * unit<T> * abs(offset) * sqrt(per_squared);
  return flat;
}

/// With the normal from the exact edges, so that it is good to its last digits however thin the polygon.
template <std::floating_point T>
[[nodiscard]] Flat<T> flat_of(const Polygon<T>& polygon) {
  return detail::plane_through<T>(polygon.vertices.front(), detail::area_vector<T>(polygon.vertices));
}
template <std::floating_point T>
[[nodiscard]] Flat<T> flat_of(const Triangle<T>& triangle) {
  return detail::plane_through<T>(triangle.a, detail::area_vector<T>({triangle.a, triangle.b, triangle.c}));
}

}  // namespace rayproof::spawn
