#pragma once
/// \file
/// Leaving a sphere, and a cylinder's side or cap.

#include <rayproof/cylinder.hpp>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/spawn/surface_point.hpp>
#include <rayproof/sphere.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// The point moved along the radius onto the sphere.
///
/// With f = p - center rounded, center + r·f/|f| is a point of the sphere whatever the rounding; computed,
/// r·f/|f| is off by 4.5ε of itself in each component, and the sum by ε. The normal has the same relative
/// error. A plane that is a above the tangent plane is clear of the sphere beside the foot by w where a >
/// w²/(2r), and inside it where a > w²/(1.5r); f's own roundings turn it by ε, which is r·ε of w.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Sphere<T>& sphere, const vec3<T>& p,
                                                      const vec3<T>& /*resolution*/) {
  constexpr auto eps = unit<T>;
  const vec3<T> f = p - sphere.center;
  const vec3<T> n = (T(1) / sqrt(dot(f, f))) * f;
  const vec3<T> arm = sphere.radius * n;
  const vec3<T> point = sphere.center + arm;
  const auto error = [&](const T& at, const T& from_center) {
    return T(eps) * abs(at) + T(6 * eps) * abs(from_center);
  };
  return {p,
          point,
          n,
          n,
          vec3<T>{error(point.x, arm.x), error(point.y, arm.y), error(point.z, arm.z)},
          T(8 * eps),
          T(1) / sphere.radius};
}

/// The point moved onto the side, along the ray from the axis, or onto the nearer cap, straight; and within
/// the other, by `resolution` along each axis, so that what goes in from there stays in.
///
/// In the plane scaled by (1/rx, 1/ry) the side is a circle and this is the sphere's derivation: (X, Y)/|(X,
/// Y)| is on the circle whatever the rounding, and rx·X/|(X, Y)| is off by 6ε of itself. Lengths grow there
/// by the larger of 1/rx and 1/ry, distances along the normal by its length here, which is as it comes: the
/// circle's gradient, off by 3ε of itself in each component. A cap's z is exact.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Cylinder<T>& cylinder, const vec3<T>& p,
                                                      const vec3<T>& resolution) {
  constexpr auto eps = unit<T>;
  const T per_x = T(1) / cylinder.rx, per_y = T(1) / cylinder.ry;
  const T x = p.x * per_x, y = p.y * per_y;
  const T from_axis = sqrt(x * x + y * y), per_axis = T(1) / from_axis;
  const T gradient_x = x * per_x, gradient_y = y * per_y;
  const T off_side = (T(1) - from_axis) * from_axis;  // times the gradient's length
  const T off_bottom = abs(p.z), off_top = abs(cylinder.height - p.z), off_cap = min(off_bottom, off_top);
  const Mask<T> is_top = off_top < off_bottom;
  // On the axis itself, or so near that squares vanish, both distances from the side are 0.
  const T squared_gradient = gradient_x * gradient_x + gradient_y * gradient_y;
  const Mask<T> is_nearer_cap =
      from_axis == T(0) || (off_cap * off_cap) * squared_gradient < off_side * off_side;
  const Mask<T> is_cap = is_nearer_cap && T(cylinder.capped ? 1 : 0) > T(0);

  const T stretch = max(per_x, per_y);
  const T inside = T(1) - (resolution.x + resolution.y) * stretch - T(16 * eps);
  const T onto = select(is_cap, min(max(inside, T(0)) * per_axis, T(1)), per_axis);
  const T from_end = resolution.z + T(8 * eps) * cylinder.height;
  const T z = select(is_cap, select(is_top, cylinder.height, T(0)),
                     clamped(p.z, from_end, cylinder.height - from_end));
  const vec3<T> point{cylinder.rx * (x * onto), cylinder.ry * (y * onto), z};
  const T zero(0);
  const auto of_side = [&](const T& side) { return select(is_cap, zero, side); };
  const T up = select(is_cap, select(is_top, T(1), T(-1)), zero);
  return {p,
          point,
          vec3<T>{of_side(gradient_x * per_axis), of_side(gradient_y * per_axis), up},
          vec3<T>{of_side(point.x), of_side(point.y), up},
          vec3<T>{of_side(T(8 * eps) * abs(point.x)), of_side(T(8 * eps) * abs(point.y)), zero},
          of_side(T(12 * eps)),
          of_side(stretch * stretch)};
}

/// How far, along each axis, no point of the body is from (0, 0, 0).
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Sphere<T>& sphere, const vec3<T>& /*p*/) {
  return magnitudes<T>(sphere.center) + vec3<T>{sphere.radius, sphere.radius, sphere.radius};
}
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Cylinder<T>& cylinder, const vec3<T>& /*p*/) {
  return vec3<T>{cylinder.rx, cylinder.ry, cylinder.height};
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
