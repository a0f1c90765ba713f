#pragma once
/// \file
/// A line and an elliptic cylinder, exactly: the quadratic of its side, the quotients of its caps' planes,
/// and which of them are hits.

#include <variant>
#include <vector>

#include "oracle/geometry/hit.hpp"

namespace rayproof::oracle {

/// One hit of the whole line.
struct CylinderHit {
  std::variant<ExactRoot, Quotient> t;
  bool is_on_side;  ///< a point of the side, its two rims included
  bool is_on_rim;
  int cap;  ///< -1 on the lower cap, 1 on the upper, 0 on neither; for points off the side
};

/// The cylinder in the scale of ObjectRay, with x and y stretched by ry and rx: the side is X² + Y² = R².
struct CylinderEquation {
  Vector<Ring> origin, direction;  ///< (ry·x, rx·y, z) of the ray, times the scale made positive
  Ring radius;                     ///< rx·ry, times the scale
  Ring height;                     ///< times the scale
  bool capped;

  CylinderEquation(const ObjectRay<Ring>& ray, const Cylinder<double>& cylinder);

  /// X² + Y² - R² along the line, a quadratic in t; all zero in a where the line is parallel to the axis.
  [[nodiscard]] ExactQuadratic side() const;
  [[nodiscard]] bool is_axis_parallel() const;

  /// Every hit of the whole line, ascending, each once.
  [[nodiscard]] std::vector<CylinderHit> hits() const;

 private:
  void add_caps(std::vector<CylinderHit>& hits, bool of_entry) const;
  void add_side(std::vector<CylinderHit>& hits) const;
};

}  // namespace rayproof::oracle
