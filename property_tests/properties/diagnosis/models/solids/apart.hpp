#pragma once
/// \file
/// How far a point, or a ray, is from a solid.

#include <optional>

#include "case/case.hpp"

namespace rayproof::diagnosis {

/// How far points of object space are from a solid that is made smaller by a margin on every side. Known of
/// spheres, boxes and capped circular cylinders, which are convex: along a ray the distance falls to its
/// least value, and then rises.
class Apart {
 public:
  /// Nothing where the case asks of another shape, or of one that the margin takes all of.
  [[nodiscard]] static std::optional<Apart> from(const Case& one, double margin);

  /// 0 inside; in units of object space, as the margin.
  [[nodiscard]] double at(const glm::dvec3& point) const;
  /// The least of that on a ray between two of its t.
  [[nodiscard]] double least(const Ray<double>& ray, double from, double to) const;

 private:
  /// All points within `radius` of a box that may be a point; a cylinder is round about the z axis.
  glm::dvec3 low_{}, high_{};
  double radius_ = 0;
  bool is_about_axis_ = false;
};

/// The smallest side of a box; the least of a capped circular cylinder's height and width; a sphere's width;
/// 0 of any other shape.
[[nodiscard]] double thickness_of(const Case& one);

}  // namespace rayproof::diagnosis
