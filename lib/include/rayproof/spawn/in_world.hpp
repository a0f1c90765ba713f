#pragma once
/// \file
/// Leaving a transformed object: onto its surface in its own space, where that is exact or nearly so, and
/// back out by the given map, which is exact too. What the inverse map is off by moves the point along the
/// surface, never off it.

#include <rayproof/spawn/flat.hpp>
#include <rayproof/spawn/round.hpp>
#include <rayproof/spawn/solid.hpp>
#include <rayproof/spawn/surface_point.hpp>
#include <rayproof/transform.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// An object-to-world map q ↦ A·q + b, its inverse, and how much that can stretch a vector.
template <class T>
struct Placement {
  vec3<T> column_x, column_y, column_z;  ///< of A
  ObjectSpace<T> inverse;
  T shrinks;  ///< the Frobenius norm of A's inverse

  [[nodiscard]] constexpr vec3<T> direction(const vec3<T>& v) const {
    return v.x * column_x + v.y * column_y + v.z * column_z;
  }
  /// |A|·|v|, component by component.
  [[nodiscard]] constexpr vec3<T> spread(const vec3<T>& v) const {
    return abs(v.x) * magnitudes<T>(column_x) + abs(v.y) * magnitudes<T>(column_y) +
           abs(v.z) * magnitudes<T>(column_z);
  }
};

template <class To, class From>
[[nodiscard]] constexpr Placement<To> convert(const Placement<From>& from) {
  return {convert<To>(from.column_x), convert<To>(from.column_y), convert<To>(from.column_z),
          convert<To>(from.inverse), To(from.shrinks)};
}

template <std::floating_point T>
[[nodiscard]] Placement<T> placement(const glm::mat<4, 4, T>& object_to_world) {
  const ObjectSpace<T> inverse = object_space<T>(object_to_world);
  const auto norm = [](const vec3<T>& x, const vec3<T>& y, const vec3<T>& z) {
    return sqrt(dot(x, x) + dot(y, y) + dot(z, z));
  };
  const vec3<T> x{object_to_world[0]}, y{object_to_world[1]}, z{object_to_world[2]};
  return {x, y, z, inverse, norm(inverse.row_x, inverse.row_y, inverse.row_z)};
}

/// How far the roundings still to come can move a point at p, along each axis of its own space: without a map
/// those of p and of an offset as small as `Proven`'s.
template <class T>
[[nodiscard]] constexpr vec3<T> resolution_at(const vec3<T>& p) {
  const T by = T(8 * unit<T>) * sum<T>(magnitudes<T>(p)) + T(least_offset<T>);
  return vec3<T>{by, by, by};
}

/// The point of the surface that the hit p is moved to.
template <template <class> class Surface, class T>
[[nodiscard]] constexpr SurfacePoint<T> leave(const Surface<T>& surface, const vec3<T>& p) {
  return surface_point(surface, p, resolution_at<T>(p));
}

/// The same of an object under a map; p is in the world.
///
/// Let x be the point of the object's surface, off by e. A·x + b, computed, is off by |A|·e + 5ε(|A||x| +
/// |b|). w = A⁻ᵀn is off by 14ε of the sum of its terms' magnitudes (4ε an entry of A⁻¹ but for a common
/// factor, 6ε the object's normal, 4ε the sums), and by |A⁻¹|·tilt; a distance along the object's normal is
/// |w| times that along the world's. Other lengths grow by |A⁻¹| at most on their way to the object.
template <template <class> class Surface, class T>
[[nodiscard]] constexpr SurfacePoint<T> leave(const Surface<T>& surface, const Placement<T>& map,
                                              const vec3<T>& p) {
  constexpr auto eps = unit<T>;
  const ObjectSpace<T>& inverse = map.inverse;
  const vec3<T> seen = inverse.point(p), sizes = magnitudes<T>(inverse.translation);
  const auto rounding_of = [&](const vec3<T>& x) { return T(5 * eps) * (map.spread(x) + sizes); };
  const vec3<T> farthest = magnitudes<T>(seen) + outermost(surface);
  const T coarse = T(16) * sum<T>(rounding_of(farthest)) + T(least_offset<T>);
  const auto along = [&](const vec3<T>& row) { return coarse * sum<T>(magnitudes<T>(row)); };
  const SurfacePoint<T> own =
      surface_point(surface, seen, vec3<T>{along(inverse.row_x), along(inverse.row_y), along(inverse.row_z)});

  const vec3<T> x = own.normal.x * inverse.row_x, y = own.normal.y * inverse.row_y,
                z = own.normal.z * inverse.row_z;
  const vec3<T> w = x + y + z;
  const T climb = sqrt(dot(w, w)), per_climb = T(1) / climb;
  const T terms = sum<T>(magnitudes<T>(x)) + sum<T>(magnitudes<T>(y)) + sum<T>(magnitudes<T>(z));
  return {p,
          map.direction(own.point) + inverse.translation,
          per_climb * w,
          climb * map.direction(own.radial),
          map.spread(own.error) + rounding_of(own.point),
          T(2) * per_climb * (T(14 * eps) * terms + map.shrinks * own.tilt) + T(6 * eps),
          own.bend * map.shrinks * map.shrinks * per_climb};
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
