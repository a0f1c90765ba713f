#pragma once
/// \file
/// Leaving a transformed object: onto its surface in its own space, where that is exact or nearly so, and
/// back out by the given map, which is exact too. What the inverse map is off by moves the point along the
/// surface, never off it.

#include <rayproof/spawn/flat.hpp>
#include <rayproof/spawn/round.hpp>
#include <rayproof/spawn/slanted.hpp>
#include <rayproof/spawn/surface_point.hpp>
#include <rayproof/transform.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// An object-to-world map q ↦ A·q + b and its inverse, and what every hit asks of their sizes.
template <class T>
struct Placement {
  vec3<T> column_x, column_y, column_z;  ///< of A
  ObjectSpace<T> inverse;
  T shrinks;                       ///< the Frobenius norm of A's inverse
  T terms;                         ///< the length of `row_sums`
  vec3<T> column_sums;             ///< of each column of A the sum of magnitudes
  vec3<T> row_sums;                ///< the same of each row of A's inverse
  vec3<T> size_x, size_y, size_z;  ///< the magnitudes of A, column by column
  vec3<T> sizes;                   ///< those of b

  [[nodiscard]] constexpr vec3<T> direction(const vec3<T>& v) const {
    return v.x * column_x + v.y * column_y + v.z * column_z;
  }
  /// |A|·v of a v without negative components.
  [[nodiscard]] constexpr vec3<T> spread(const vec3<T>& v) const {
    return v.x * size_x + v.y * size_y + v.z * size_z;
  }
};

template <class To, class From>
[[nodiscard]] constexpr Placement<To> convert(const Placement<From>& from) {
  return {convert<To>(from.column_x),    convert<To>(from.column_y), convert<To>(from.column_z),
          convert<To>(from.inverse),     To(from.shrinks),           To(from.terms),
          convert<To>(from.column_sums), convert<To>(from.row_sums), convert<To>(from.size_x),
          convert<To>(from.size_y),      convert<To>(from.size_z),   convert<To>(from.sizes)};
}

template <std::floating_point T>
[[nodiscard]] Placement<T> placement(const glm::mat<4, 4, T>& object_to_world) {
  const ObjectSpace<T> inverse = object_space<T>(object_to_world);
  const auto norm = [](const vec3<T>& x, const vec3<T>& y, const vec3<T>& z) {
    return sqrt(dot(x, x) + dot(y, y) + dot(z, z));
  };
  const vec3<T> x{object_to_world[0]}, y{object_to_world[1]}, z{object_to_world[2]};
  const auto sums = [](const vec3<T>& a, const vec3<T>& b, const vec3<T>& c) {
    return vec3<T>{sum<T>(magnitudes<T>(a)), sum<T>(magnitudes<T>(b)), sum<T>(magnitudes<T>(c))};
  };
  const vec3<T> row_sums = sums(inverse.row_x, inverse.row_y, inverse.row_z);
  return {x,
          y,
          z,
          inverse,
          norm(inverse.row_x, inverse.row_y, inverse.row_z),
          sqrt(dot(row_sums, row_sums)),
          sums(x, y, z),
          row_sums,
          magnitudes<T>(x),
          magnitudes<T>(y),
          magnitudes<T>(z),
          magnitudes<T>(inverse.translation)};
}

/// How far the roundings still to come can move a point at p, along each axis of its own space: without a map
/// those of p and of an offset as small as `Proven`'s.
template <class T>
[[nodiscard]] constexpr vec3<T> resolution_at(const vec3<T>& p) {
  const T by = T(8 * unit<T>) * sum<T>(magnitudes<T>(p)) + T(least_offset<T>);
  return same_along_each_axis<T>(by);
}

/// The point of the surface that the hit p is moved to.
template <template <class> class Surface, class T>
[[nodiscard]] constexpr SurfacePoint<T> leave(const Surface<T>& surface, const vec3<T>& p) {
  return surface_point(surface, p, resolution_at<T>(p));
}

/// The same of an object under a map; p is in the world.
///
/// Let x be the point of the object's surface, off by e. A·x + b, computed, is off by |A|·e + 5ε(|A||x| +
/// |b|), and |x| is no more than outermost(surface), whatever the hit. w = A⁻ᵀn is off by 14ε of the sum of
/// its terms' magnitudes (4ε an entry of A⁻¹ but for a common factor, 6ε the object's normal, 4ε the sums),
/// no more than that of a unit vector can be, and by |A⁻¹|·tilt; a distance along the object's normal is |w|
/// times that along the world's. Other lengths grow by |A⁻¹| at most on their way to the object.
template <template <class> class Surface, class T>
[[nodiscard]] constexpr SurfacePoint<T> leave(const Surface<T>& surface, const Placement<T>& map,
                                              const vec3<T>& p) {
  constexpr auto eps = unit<T>;
  const ObjectSpace<T>& inverse = map.inverse;
  const vec3<T> seen = inverse.point(p);
  const vec3<T> farthest = outermost(surface, seen);
  const T coarse = T(160 * eps) * (dot(map.column_sums, farthest) + sum<T>(map.sizes)) + T(least_offset<T>);
  const SurfacePoint<T> own = surface_point(surface, seen, coarse * map.row_sums);

  const vec3<T> x = own.normal.x * inverse.row_x, y = own.normal.y * inverse.row_y,
                z = own.normal.z * inverse.row_z;
  const vec3<T> w = x + y + z;
  const T climb = sqrt(dot(w, w)), per_climb = T(1) / climb;
  return {p,
          map.direction(own.point) + inverse.translation,
          per_climb * w,
          climb * map.direction(own.radial),
          map.spread(own.error) + T(5 * eps) * (map.spread(farthest) + map.sizes),
          per_climb * (T(28 * eps) * map.terms + T(2) * map.shrinks * own.tilt) + T(6 * eps),
          own.bend * (map.shrinks * map.shrinks * per_climb),
          own.is_flat};
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
