#pragma once
/// \file
/// The box around a figure's points, rounded outwards: what a shape's figures file adds its points to.

#include <array>
#include <cmath>

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/filters.hpp"
#include "viz/render/bounds.hpp"

namespace rayproof::render {

using oracle::Interval;
using Point = oracle::Vector<Interval>;

[[nodiscard]] double below(const Interval& x);
[[nodiscard]] double above(const Interval& x);

[[nodiscard]] inline std::array<Interval, 3> coordinates_of(const Point& p) { return {p.x, p.y, p.z}; }

/// Grows around the images of points under the object's transform.
class Hull {
 public:
  explicit Hull(const std::optional<glm::dmat4>& transform) : transform_(transform) {}

  void add(const Point& p);
  /// The eight corners of a box along the axes.
  void add_box(const Point& low, const Point& high);

  /// Nothing where a number is too large to reason about.
  [[nodiscard]] std::optional<Bounds> bounds() const {
    if (is_sound_) return bounds_;
    return std::nullopt;
  }

 private:
  [[nodiscard]] Point image(const Point& p) const;

  const std::optional<glm::dmat4>& transform_;
  Bounds bounds_{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
  bool is_sound_ = true;
};

}  // namespace rayproof::render
