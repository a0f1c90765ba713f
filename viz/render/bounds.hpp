#pragma once
/// \file
/// Boxes that are known for certain to hold a figure, and rays that are known for certain to pass a box by.

#include <optional>

#include "viz/render/scene/scene.hpp"

namespace rayproof::render {

/// No larger numbers are reasoned about: their products could overflow.
inline constexpr double largest_sound = 0x1p+500;

/// All points from low to high, bounds included.
struct Bounds {
  glm::dvec3 low{}, high{};

  [[nodiscard]] Bounds around(const Bounds& other) const;
  /// Larger on every side.
  [[nodiscard]] Bounds grown(double margin) const;
};

/// A box around the object in the world, rounded outwards from intervals: no point of the exact figure lies
/// outside it. Nothing for a plane, or where a number is beyond 2^500, so that overflow can't spoil the
/// proof.
[[nodiscard]] std::optional<Bounds> bounds_of(const Object& object);

/// A ray prepared for many boxes.
///
/// The slabs of a box are computed as (bound - o)·(1/d): three roundings, each off by a factor of at most
/// 1 ± 2^-53 and, beyond 2^-1022, by 2^-1074. Widening each t by 2^-50 of itself and by 2^-1000 outweighs
/// that, so that `entry` never says "none" of a box that the exact ray meets. (Numbers beyond 2^500, and
/// directions below 2^-500 that are not 0, are taken as no constraint.)
class RayAgainstBoxes {
 public:
  explicit RayAgainstBoxes(const Ray<double>& ray);

  /// A t not above the one at which the ray first is in the box, t_min where it begins inside; nothing where
  /// the ray's interval up to `t_max` certainly has no point in it.
  [[nodiscard]] std::optional<double> entry(const Bounds& bounds, double t_max) const;

 private:
  enum class AxisState { crossed, parallel, unknown };

  Ray<double> ray_;
  glm::dvec3 inverse_{};
  std::array<AxisState, 3> axes_{};
};

}  // namespace rayproof::render
