#pragma once
/// \file
/// What the ray/cylinder methods share: the plane in which the side is a circle, and how the hits on the side
/// and the two heights z = 0 and z = height make up an answer.

#include <rayproof/box/slab.hpp>
#include <rayproof/cylinder.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::cylinder {

/// The ray seen along the axis, in the plane scaled by (1/rx, 1/ry): there the side is the unit circle.
template <class T>
struct ScaledRay {
  T fx, fy;  ///< origin
  T dx, dy;  ///< direction
};

template <class T>
[[nodiscard]] constexpr ScaledRay<T> scaled_to_circle(const Ray<T>& ray, const Cylinder<T>& cylinder) {
  step<T>("Scale the ellipse to the unit circle",
          "Dividing x by rx and y by ry turns the side into the circle x² + y² = 1 and leaves t as it is.");
  return {named("f.x", ray.origin.x / cylinder.rx), named("f.y", ray.origin.y / cylinder.ry),
          named("d.x", ray.direction.x / cylinder.rx), named("d.y", ray.direction.y / cylinder.ry)};
}

/// When the line is between z = 0 and z = height.
template <class T>
[[nodiscard]] constexpr box::Slab<T> between_heights(const Ray<T>& ray, const Cylinder<T>& cylinder) {
  step<T>("Meet the planes of both ends",
          "The ray is at the cylinder's height between the planes z = 0 and z = {height}: from t = e₀ to t = "
          "e₁.");
  const auto [entry, exit] = box::slab_of(ray.direction.z, -ray.origin.z, cylinder.height - ray.origin.z);
  return {named("e₀", entry), named("e₁", exit)};
}

/// Those of two roots that are hits; none where the discriminant is negative or NaN. One alone is the upper.
template <class T>
[[nodiscard]] constexpr Roots<T> kept(const Roots<T>& roots, const Mask<T>& is_lo, const Mask<T>& is_hi) {
  const T nan = T(not_a_number<T>);
  const Mask<T> is_real = T(0) <= roots.discriminant;
  const Mask<T> is_any = is_real && (is_lo || is_hi);
  const T upper = select(is_hi, roots.hi, roots.lo);
  return {select(is_any, roots.discriminant, T(-1)), select(is_real && is_lo && is_hi, roots.lo, nan),
          select(is_any, upper, nan)};
}

/// The hits of an open cylinder: the roots of its side between both heights.
template <class T>
[[nodiscard]] constexpr Roots<T> open_hits(const Roots<T>& side, const box::Slab<T>& heights) {
  step<T>("Keep the roots between both ends",
          "The side is endless: of its roots s₀ = {s₀} and s₁ = {s₁} those from e₀ = {e₀} to e₁ = {e₁} are "
          "hits.");
  return kept<T>(side, heights.entry <= side.lo && side.lo <= heights.exit,
                 heights.entry <= side.hi && side.hi <= heights.exit);
}

/// The hits of a capped cylinder, which is what is inside the side and between both heights. A single t is
/// one hit, unless it is the two roots of the side rounded to one number.
template <class T>
[[nodiscard]] constexpr Roots<T> capped_hits(const Roots<T>& side, const box::Slab<T>& heights) {
  const auto [entry, exit] = box::overlap(box::Slab<T>{side.lo, side.hi}, heights);
  return kept<T>({side.discriminant, entry, exit}, entry < exit || (entry == exit && side.lo == side.hi),
                 entry <= exit);
}

/// The roots of an open cylinder's side, and of a ring, which is what is left of it at height 0, also the one
/// hit of a line along the axis through the ring.
template <class T>
[[nodiscard]] constexpr Roots<T> roots_of_open(const Roots<T>& side, const Mask<T>& is_through_ring,
                                               const T& t) {
  return {select(is_through_ring, T(1), side.discriminant),
          select(is_through_ring, T(not_a_number<T>), side.lo), select(is_through_ring, t, side.hi)};
}

/// The hits of either, given the roots of the side and the sign of `outside` for the origin: negative inside
/// the circle, 0 on it. It is for a line along the axis, which is inside the side for all t or for none: no
/// root's formula has anything to say of it.
template <class T>
[[nodiscard]] constexpr Roots<T> hits(const Ray<T>& ray, const Cylinder<T>& cylinder, const Roots<T>& side,
                                      const T& outside) {
  const box::Slab<T> heights = between_heights(ray, cylinder);
  const Mask<T> is_along = ray.direction.x == T(0) && ray.direction.y == T(0);
  if (!cylinder.capped) {
    const Mask<T> is_ring = cylinder.height == T(0) && ray.direction.z != T(0);
    return open_hits(roots_of_open(side, is_along && is_ring && outside == T(0), heights.entry), heights);
  }
  const T end = select(outside <= T(0), T(infinity<T>), T(-infinity<T>));
  const Roots<T> inside{select(is_along, T(1), side.discriminant), select(is_along, -end, side.lo),
                        select(is_along, end, side.hi)};
  return capped_hits(inside, heights);
}

}  // namespace rayproof::cylinder

#include <rayproof/rounding/as_before.hpp>
