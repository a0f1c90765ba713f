#pragma once
#include <rayproof/box.hpp>
#include <rayproof/box/correction.hpp>
#include <rayproof/box/exact_slab.hpp>
#include <rayproof/box/slabs.hpp>
#include <rayproof/box/slabs_inverse.hpp>
#include <rayproof/formulas/bounded_roots.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// Correctly rounded: the verdict is the exact one, and each t the exact t rounded once, ties to even.
///
/// SlabsInverse runs in double for a ray in float, in double-double for one in double, in packs too; its
/// answer stands where the error bound below leaves no doubt of which comes first, entry or exit, and of the
/// rounding of both, which is nearly everywhere. The rest goes to slabs with nothing rounded before the last
/// step: two t are compared by their exact cross products, so that an edge that is touched counts once.
///
/// An answer is never rounded across an end of the ray's interval; entry and exit may round to one number and
/// are still two, with a discriminant of 1. Holds for all finite floats; for doubles while every number that
/// is not 0 lies within 2^±480, beyond which the products over- or underflow; under a transform within 2^±24.
struct Rounded {
  static constexpr const char* name = "rounded";
  static constexpr const char* title = "correctly rounded: slabs with more digits, exact where in doubt";
  static constexpr Source source = sources::ziv;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .ulp = {.measured = 0.5, .promised = 0.501},
      .hit = box_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 480, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::ulp, Claim::rounded, Claim::bounded}};

  /// What is tried first where the nearest hit alone is asked for.
  using Correction = box::Correction;

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Box<T>& box) {
    return quick_or_exact_roots<Rounded>(ray, box);
  }

  /// By expansions alone.
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> exact_roots(const Ray<T>& ray, const Box<T>& box) {
    return met_exactly<Rounded>(ray, box);
  }

  /// The same under a transform.
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                               const Box<T>& box) {
    return quick_or_exact_roots<Rounded>(space, ray, box);
  }

  /// Slabs of a ray in object space whose numbers have bounds on their errors.
  template <class W>
  [[nodiscard]] static constexpr Enclosed<W> enclosed_in_space(const Ray<Bounded<W>>& ray,
                                                               const Box<Bounded<W>>& box) {
    return enclosed_by_bounds(Slabs::roots(ray, box));
  }

  /// The chord of a ray from o along d, as met_exactly has them.
  template <std::floating_point T, class Number, class Unit>
  [[nodiscard]] static Roots<T> meet(const Ray<T>& ray, const Box<T>& box, const Vec3<Number>& o,
                                     const Vec3<Number>& d, const Unit& unit) {
    if (!are_finite(box.min, box.max)) return no_roots<T>;
    step<T>("Form the distance to each plane exactly",
            "No difference is rounded, so each entry and exit is an exact quotient.");
    const bool is_mirrored = sign(unit) < 0;  // times a negative number the upper corner is below
    const auto below = unit * exact_vector<double>(is_mirrored ? box.max : box.min) - o;
    const auto above = unit * exact_vector<double>(is_mirrored ? box.min : box.max) - o;
    return exact_chord(ray, std::array{ExactSlab(d.x, below.x, above.x), ExactSlab(d.y, below.y, above.y),
                                       ExactSlab(d.z, below.z, above.z)});
  }

  /// Slabs in double on numbers that are floats, or in double-double on doubles, and what is known of them.
  ///
  /// With u the unit roundoff each t is (plane - o)·(1/d), three roundings, so off by at most 3.01u of its
  /// size, and 0 or of the wrong sign never. The last entry and the first exit keep that bound: whichever
  /// slab they come from, the exact one cannot be farther than its own rounding. The order of the two is sure
  /// where they are farther apart than both errors together. Where the ray runs along a slab it is inside by
  /// an exact comparison, or never meets the box: then the entry is NaN. Of a ray or a box that is not finite
  /// nothing is sure.
  ///
  /// Nothing over- or underflows: floats are whole multiples of 2^-149 below 2^128.
  template <class W>
  [[nodiscard]] static constexpr Enclosed<W> enclosed(const Ray<W>& ray, const Box<W>& box) {
    const auto [entry, exit] = SlabsInverse::common_interval(ray, box);
    using N = Leading<W>;
    const N bound(5.5 * unit_roundoff<W>);  // 3.01u and two roundings more
    const N entry_error = bound * abs(leading(entry));
    const N exit_error = bound * abs(leading(exit));
    const Mask<W> is_apart = entry_error + exit_error < abs(leading(exit - entry));
    const auto sum = [](const auto& v) { return leading(v).x + leading(v).y + leading(v).z; };
    const N all = sum(ray.origin) + sum(ray.direction) + (sum(box.min) + sum(box.max));
    const Mask<W> is_finite = abs(all) < N(infinity<W>);
    return {chord(entry, exit), entry_error, exit_error, (is_apart || entry != entry) && is_finite};
  }
};

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
