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
  SurfacePoint<T> made = surface_point(surface, p, resolution_at<T>(p));
  if constexpr (std::is_same_v<Surface<T>, Cylinder<T>>) make_unit(made);
  return made;
}

/// The same of an object under a map; p is in the world.
///
/// Let x be the point of the object's surface, off by e. A·x + b, computed, is off by |A|·e + 5ε(|A||x| +
/// |b|), and |x| is no more than outermost(surface), whatever the hit. w = A⁻ᵀn is off by 14ε of Σ|nᵢ||rowᵢ|
/// (4ε an entry of A⁻¹ but for a common factor, 6ε a component of the object's normal, 4ε the sums), no more
/// than that of a unit vector can be, and of a plane by |A⁻¹|·tilt; a distance along the object's normal is
/// |w| times that along the world's. Other lengths grow by |A⁻¹| at most on their way to the object.
template <template <class> class Surface, class T>
[[nodiscard]] constexpr SurfacePoint<T> leave(const Surface<T>& surface, const Placement<T>& map,
                                              const vec3<T>& p) {
  constexpr auto eps = unit<T>;
  const ObjectSpace<T>& inverse = map.inverse;
  const vec3<T> seen = inverse.point(p);
  const vec3<T> farthest = outermost(surface, seen);
  // Thirty-two times what mapping a point rounds: more than the point, its offset and the next ray's start
  // can lose together. It is not tight: it only keeps the point this far from the ends of its face.
  const T coarse = T(160 * eps) * (dot(map.column_sums, farthest) + sum<T>(map.sizes)) + T(least_offset<T>);
  const SurfacePoint<T> own = surface_point(surface, seen, coarse * map.row_sums);

  const vec3<T> x = own.normal.x * inverse.row_x, y = own.normal.y * inverse.row_y,
                z = own.normal.z * inverse.row_z;
  SurfacePoint<T> made{p,
                       map.direction(own.point) + inverse.translation,
                       x + y + z,
                       map.direction(own.radial),
                       map.spread(own.error) + T(5 * eps) * (map.spread(farthest) + map.sizes),
                       T(28 * eps) * dot(magnitudes<T>(own.normal), map.row_lengths),
                       own.bend * (map.shrinks * map.shrinks),
                       own.is_flat};
  if constexpr (std::is_same_v<Surface<T>, Flat<T>>) made.tilt = made.tilt + T(2) * map.shrinks * own.tilt;
  const T per_length = make_unit(made);
  made.tilt = per_length * made.tilt + T(6 * eps);
  return made;
}
template <std::floating_point T>
[[nodiscard]] SurfacePoint<T> leave(const Slanted<T>& solid, const Placement<T>& map, const vec3<T>& p) {
  return leave(place(solid, map), p);
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
