#pragma once
/// \file
/// Rays that are known for certain to pass a box by.

#include <rayproof/objects/hull.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::objects {

/// A ray prepared for many boxes.
///
/// The slabs of a box are computed as (bound - o)·(1/d): three roundings, each off by a factor of at most
/// 1 ± 2^-53 and, beyond 2^-1022, by 2^-1074. Widening t by 2^-50 of itself and by 2^-1000 outweighs that, so
/// that `entry` never says "none" of a box that the exact ray meets. The rounding of bound ± margin is less
/// than the margin: the box is met that was given, and not quite the one that the margin makes. (Numbers
/// beyond 2^500, and directions below 2^-500 that are not 0, are taken as no constraint.)
class RayAgainstBoxes {
 public:
  /// Every box is taken to be larger by `margin` on each side.
  explicit RayAgainstBoxes(const Ray<double>& ray, double margin = 0) : ray_(ray), margin_(margin) {
    for (int i = 0; i < 3; ++i) {
      const double o = std::abs(ray.origin[i]), d = std::abs(ray.direction[i]);
      const bool is_sound = o < largest_sound && d < largest_sound && (d > 1 / largest_sound || d == 0);
      inverse_[i] = is_sound ? 1 / ray.direction[i] : not_a_number<double>;
    }
  }

  /// A t not above the one at which the ray first is in the box, t_min where it begins inside; NaN where the
  /// ray's interval up to `t_max` certainly has no point in it.
  ///
  /// A ray parallel to an axis has 1/d = ±∞ there, and slabs at ±∞, or at NaN on the boundary itself. A NaN,
  /// as of an axis without a sound number, constrains nothing: `max` and `min` keep their first argument.
  template <class Box>
  [[nodiscard]] double entry(const Box& box, double t_max) const {
    double in = -HUGE_VAL, out = HUGE_VAL;
    const auto cross_slab = [&](double low, double high, double origin, double inverse) {
      const double to_low = (low - margin_ - origin) * inverse;
      const double to_high = (high + margin_ - origin) * inverse;
      const bool is_upward = inverse > 0;
      in = std::max(in, is_upward ? to_low : to_high);
      out = std::min(out, is_upward ? to_high : to_low);
    };
    cross_slab(box.low.x, box.high.x, ray_.origin.x, inverse_.x);
    cross_slab(box.low.y, box.high.y, ray_.origin.y, inverse_.y);
    cross_slab(box.low.z, box.high.z, ray_.origin.z, inverse_.z);
    const auto doubt = [](double t) { return 0x1p-50 * std::abs(t) + 0x1p-1000; };
    const double first = std::max(ray_.t_min, in - doubt(in));
    const double last = std::min(std::min(ray_.t_max, t_max), out + doubt(out));
    return in < HUGE_VAL && out > -HUGE_VAL && first <= last ? first : not_a_number<double>;
  }

  [[nodiscard]] const Ray<double>& ray() const { return ray_; }
  [[nodiscard]] double margin() const { return margin_; }

 private:
  Ray<double> ray_;
  double margin_;
  glm::dvec3 inverse_{};
};

/// The largest coordinate of a vector, and of a box that has points.
[[nodiscard]] inline double reach_of(const glm::dvec3& v) {
  return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
}
[[nodiscard]] inline double reach_of(const Bounds& bounds) {
  return std::max(reach_of(bounds.low), reach_of(bounds.high));
}

/// A ray and boxes that are larger by this part of the scene: of the ray's origin and the boxes' reach.
[[nodiscard]] inline RayAgainstBoxes with_margin(const Ray<double>& ray, double part, double reach) {
  return RayAgainstBoxes(ray, part * (reach_of(ray.origin) + reach));
}

}  // namespace rayproof::objects

#include <rayproof/rounding/as_before.hpp>
