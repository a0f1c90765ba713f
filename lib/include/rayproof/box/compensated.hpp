#pragma once
#include <rayproof/box.hpp>
#include <rayproof/box/exact_slab.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// Slabs with nothing rounded before the last step: two t are compared by their exact cross products, so the
/// verdict is the exact one, and an edge that is touched counts once.
///
/// An answer is never rounded across an end of the ray's interval; entry and exit may round to one number and
/// are still two, with a discriminant of 1. Holds for all finite floats; for doubles while every number that
/// is not 0 lies within 2^±480, beyond which the products over- or underflow.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "slabs compared exactly by expansions";
  static constexpr Source source = sources::shewchuk;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .ulp = {.measured = 0.5, .promised = 0.501},
      .hit = box_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 480, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::ulp, Claim::rounded}};

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Box<T>& box) {
    if (!are_finite(ray.origin, ray.direction, box.min, box.max)) return no_roots<T>;

    step<T>("Form the distance to each plane exactly",
            "No difference is rounded, so each entry and exit is an exact quotient.");
    const auto o = exact_vector<double>(ray.origin);
    const auto d = exact_vector<double>(ray.direction);
    const auto below = exact_vector<double>(box.min) - o;
    const auto above = exact_vector<double>(box.max) - o;

    using AxisSlab = ExactSlab<2, 1>;
    return exact_chord(ray, std::array{AxisSlab(d.x, below.x, above.x), AxisSlab(d.y, below.y, above.y),
                                       AxisSlab(d.z, below.z, above.z)});
  }
};

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
