#pragma once
/// \file
/// Boxes along the axes that are certain to hold what lies in them.

#include <algorithm>
#include <cmath>
#include <optional>
#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/transform.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::objects {

/// No larger numbers are reasoned about: their products could overflow.
inline constexpr double largest_sound = 0x1p+500;

/// All points from low to high, bounds included; none at first.
struct Bounds {
  glm::dvec3 low{HUGE_VAL}, high{-HUGE_VAL};

  /// The least box that holds this one and another.
  [[nodiscard]] Bounds around(const Bounds& other) const {
    return {glm::min(low, other.low), glm::max(high, other.high)};
  }
  /// Larger by `margin` on every side.
  [[nodiscard]] Bounds grown(double margin) const { return {low - margin, high + margin}; }
};

/// A number, or a vector of such, and how far the exact one may be from it.
using BoundedPoint = Vec3<Bounded<double>>;

[[nodiscard]] inline double not_above(const Bounded<double>& x) {
  return std::nextafter(x.value - x.error, -HUGE_VAL);
}
[[nodiscard]] inline double not_below(const Bounded<double>& x) {
  return std::nextafter(x.value + x.error, HUGE_VAL);
}

/// Grows around the images of points under an object's map, rounded outwards: no point of the convex hull of
/// the exact images lies outside it.
class Hull {
 public:
  /// `space`: that of the object, of which the map to the world is looked at; nothing for the world itself.
  explicit Hull(const std::optional<ObjectSpace<double>>& space) : space_(space) {}

  void add(const BoundedPoint& p) {
    const BoundedPoint image = space_ ? image_of(p) : p;
    int axis = 0;
    for (const Bounded<double>* x : {&image.x, &image.y, &image.z}) {
      const double low = not_above(*x), high = not_below(*x);
      bounds_.low[axis] = std::min(bounds_.low[axis], low);
      bounds_.high[axis] = std::max(bounds_.high[axis], high);
      is_sound_ = is_sound_ && low > -largest_sound && high < largest_sound;  // also false for NaN
      ++axis;
    }
  }

  /// The eight corners of a box along the axes.
  void add_box(const BoundedPoint& low, const BoundedPoint& high) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto of = [&](unsigned axis, const Bounded<double>& lower, const Bounded<double>& upper) {
        return (corner >> axis & 1U) != 0 ? upper : lower;
      };
      add({of(0, low.x, high.x), of(1, low.y, high.y), of(2, low.z, high.z)});
    }
  }

  /// No box is to be found: of a shape without points.
  void give_up() { is_sound_ = false; }

  /// Nothing where a number is too large to reason about, or NaN.
  [[nodiscard]] std::optional<Bounds> bounds() const {
    if (is_sound_) return bounds_;
    return std::nullopt;
  }

 private:
  [[nodiscard]] BoundedPoint image_of(const BoundedPoint& p) const {
    const auto exactly = [](const glm::dvec3& v) { return convert<Bounded<double>>(v); };
    return p.x * exactly(space_->column_x) + p.y * exactly(space_->column_y) +
           p.z * exactly(space_->column_z) + exactly(space_->translation);
  }

  const std::optional<ObjectSpace<double>>& space_;
  Bounds bounds_{};
  bool is_sound_ = true;
};

}  // namespace rayproof::objects

#include <rayproof/rounding/as_before.hpp>
