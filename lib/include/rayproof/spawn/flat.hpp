#pragma once
/// \file
/// Leaving a plane, a triangle or a polygon: all are left as planes, in one form that is made once for each.

#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/plane.hpp>
#include <rayproof/polygon.hpp>
#include <rayproof/spawn/area_vector.hpp>
#include <rayproof/spawn/surface_point.hpp>
#include <rayproof/transform.hpp>
#include <rayproof/triangle.hpp>

#include <rayproof/rounding/as_written.hpp>

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
          T(0),
          true};
}

/// A plane goes on without end: how far it is near p.
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Flat<T>& /*flat*/, const vec3<T>& p) {
  return magnitudes<T>(p);
}

namespace detail {

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

/// With the normal from the exact edges, so that it is good to its last digits however thin the polygon. Of
/// one without vertices all is NaN.
template <std::floating_point T>
[[nodiscard]] Flat<T> flat_of(const Polygon<T>& polygon) {
  if (polygon.vertices.empty()) {
    const vec3<T> nowhere(not_a_number<T>);
    return detail::plane_through<T>(nowhere, nowhere);
  }
  return detail::plane_through<T>(polygon.vertices.front(), detail::area_vector<T>(polygon.vertices));
}
template <std::floating_point T>
[[nodiscard]] Flat<T> flat_of(const Triangle<T>& triangle) {
  return detail::plane_through<T>(triangle.a, detail::area_vector<T>({triangle.a, triangle.b, triangle.c}));
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
