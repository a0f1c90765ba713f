#pragma once
#include <rayproof/box/bounded_slab.hpp>
#include <rayproof/cylinder/exact_hits.hpp>
#include <rayproof/cylinder/side.hpp>
#include <rayproof/formulas/bounded_roots.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/sphere/rounded.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::cylinder {

/// Correctly rounded: the verdict is the exact one, tangents and rims that are touched included, and each t
/// the exact t rounded once, ties to even.
///
/// Side and heights are met in double for a ray in float, in double-double for one in double, in packs too;
/// that answer stands where the error bounds below leave no doubt of hit or miss, of which comes first, root
/// or height, and of the rounding, which is nearly everywhere but along the axis. The rest goes to
/// expansions (ExactCylinderHits). An answer is never rounded across an end of the ray's interval.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±100, beyond which
/// the products, of degree six, or a root itself over- or underflow; under a transform, where they are of
/// degree 16, within 2^±12.
/// Radii of 0 and negative heights make no cylinder and are missed.
struct Rounded {
  static constexpr const char* name = "rounded";
  static constexpr const char* title = "correctly rounded: with more digits, exact where in doubt";
  static constexpr Source source = sources::ziv;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 1, .promised = 4},
      .ulp = {.measured = 0.501, .promised = 0.51},
      .hit = cylinder_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 100, .reach_transformed = 12, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp, Claim::rounded}};

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    return quick_or_exact_roots<Rounded>(ray, cylinder);
  }
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> exact_roots(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    return met_exactly<Rounded>(ray, cylinder);
  }

  /// The same under a transform.
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                               const Cylinder<T>& cylinder) {
    return quick_or_exact_roots<Rounded>(space, ray, cylinder);
  }

  /// Side and heights met by a ray in object space whose numbers have bounds on their errors.
  template <class W>
  [[nodiscard]] static constexpr Enclosed<W> enclosed_in_space(const Ray<Bounded<W>>& ray,
                                                               const Cylinder<Bounded<W>>& cylinder) {
    const auto side =
        enclosed_by_bounds(sphere::Centred::roots(seen_along_axis(ray, cylinder), circle_of(cylinder)));
    const auto [entry, exit] = between_heights(ray, cylinder);
    using N = Leading<W>;
    const N entry_error = error_with_room(entry), exit_error = error_with_room(exit);
    const box::BoundedSlab<W> heights{entry.value, exit.value, entry_error, exit_error,
                                      entry_error + exit_error < N(infinity<W>)};
    return cylinder.capped ? inside(side, heights) : between(side, heights);
  }

  /// The hits of a ray from o along d, as met_exactly has them.
  template <std::floating_point T, class Number, class Unit>
  [[nodiscard]] static Roots<T> meet(const Ray<T>& ray, const Cylinder<T>& cylinder, const Vec3<Number>& o,
                                     const Vec3<Number>& d, const Unit& unit) {
    return ExactCylinderHits::meet(ray, cylinder, o, d, unit);
  }

  /// Side and heights met in double on numbers that are floats, or in double-double on doubles, and what is
  /// known of them.
  ///
  /// Times rx·ry, the plane in which the side is a circle takes products of two given numbers, which are
  /// exact: the circle is a sphere's section at z = 0, and sphere::Rounded encloses its roots. What is
  /// derived there for given numbers holds for these too: products of theirs are rounded where those of given
  /// ones are exact, but f is not, nor is a third term added, so that f·d is off by 2u|f||d| and t_c by
  /// 6u|f|/|d|, less than the 4u and 8u there; r² is off by u of itself, for which δD < 2^5·u·S·(r + …) has
  /// room. Where D² overflows, D is far from 0; nothing that counts underflows, since no number is below
  /// 2^-298.
  ///
  /// Of the heights' t the numerator is rounded once and the quotient once, so that they are off by 2.01u of
  /// their size, and by two roundings more in the test. They are NaN where the ray's own z are; a ray level
  /// with the ends, which has no such t, has its z looked at: a double beyond the reach of double-doubles is
  /// NaN.
  template <class W>
  [[nodiscard]] static constexpr Enclosed<W> enclosed(const Ray<W>& ray, const Cylinder<W>& cylinder) {
    const Enclosed<W> side = sphere::Rounded::enclosed(seen_along_axis(ray, cylinder), circle_of(cylinder));
    const auto [entry, exit] = between_heights(ray, cylinder);
    using N = Leading<W>;
    const auto error_of = [](const W& t) {
      return N(5 * unit_roundoff<W>) * min(abs(leading(t)), N(0x1p1000));
    };
    const box::BoundedSlab<W> heights{
        entry, exit, error_of(entry), error_of(exit),
        entry == entry && ray.origin.z == ray.origin.z && abs(leading(cylinder.height)) < N(infinity<W>)};
    return cylinder.capped ? inside(side, heights) : between(side, heights);
  }

 private:
  /// The ray in the plane in which the side is a circle, times rx·ry.
  template <class W>
  static constexpr Ray<W> seen_along_axis(const Ray<W>& ray, const Cylinder<W>& cylinder) {
    const vec3<W>&o = ray.origin, &d = ray.direction;
    return {{o.x * cylinder.ry, o.y * cylinder.rx, W(0)},
            {d.x * cylinder.ry, d.y * cylinder.rx, W(0)},
            ray.t_min,
            ray.t_max};
  }
  template <class W>
  static constexpr Sphere<W> circle_of(const Cylinder<W>& cylinder) {
    return {{W(0), W(0), W(0)}, cylinder.rx * cylinder.ry};
  }

  /// The hits of a capped cylinder: the chord that side and heights have in common.
  template <class W>
  static constexpr Enclosed<W> inside(const Enclosed<W>& side, const box::BoundedSlab<W>& heights) {
    const auto& [D, lo, hi] = side.roots;
    const Mask<W> is_off_side = D < W(0);
    const Enclosed<W> chord =
        box::enclosed_chord(box::BoundedSlab<W>{lo, hi, side.lo_error, side.hi_error, side.is_sure}, heights);
    return {{select(is_off_side, W(-1), chord.roots.discriminant), chord.roots.lo, chord.roots.hi},
            chord.lo_error,
            chord.hi_error,
            heights.is_sure && ((is_off_side && side.is_sure) || chord.is_sure)};
  }

  /// The hits of an open cylinder: the roots of its side that lie between both heights.
  template <class W>
  static constexpr Enclosed<W> between(const Enclosed<W>& side, const box::BoundedSlab<W>& heights) {
    const W after = heights.entry + heights.entry_error, before = heights.exit - heights.exit_error;
    const W earliest = heights.entry - heights.entry_error, latest = heights.exit + heights.exit_error;
    const auto is_between = [&](const W& t, const Leading<W>& error) {
      return after < t - error && t + error < before;
    };
    const auto is_outside = [&](const W& t, const Leading<W>& error) {
      return t + error < earliest || latest < t - error;
    };
    const auto& [D, lo, hi] = side.roots;
    const Mask<W> is_lo = is_between(lo, side.lo_error), is_hi = is_between(hi, side.hi_error);
    const Mask<W> is_lo_sure = is_lo || is_outside(lo, side.lo_error);
    const Mask<W> is_hi_sure = is_hi || is_outside(hi, side.hi_error);
    return {kept<W>(side.roots, is_lo, is_hi), side.lo_error, side.hi_error,
            side.is_sure && heights.is_sure && (D < W(0) || (is_lo_sure && is_hi_sure))};
  }
};

}  // namespace rayproof::cylinder

#include <rayproof/rounding/as_before.hpp>
