#pragma once
/// \file
/// A line and an elliptic cylinder, exactly: the quadratic of its side and the quotients of its caps' planes.

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/root.hpp"

namespace rayproof::oracle {

/// The cylinder in the scale of ObjectRay, with x and y stretched by ry and rx: the side is X² + Y² = R².
struct CylinderEquation {
  Vector<Ring> origin, direction;  ///< (ry·x, rx·y, z) of the ray, times the scale
  Ring radius;                     ///< rx·ry, times the scale
  Ring height;                     ///< times the scale

  CylinderEquation(const ObjectRay<Ring>& ray, const Cylinder<double>& cylinder)
      : origin(ray.origin),
        direction(ray.direction),
        radius(ray.scaled(Ring(cylinder.rx) * Ring(cylinder.ry))),
        height(ray.scaled(Ring(cylinder.height))) {
    for (Vector<Ring>* v : {&origin, &direction}) {
      v->x = v->x * Ring(cylinder.ry);
      v->y = v->y * Ring(cylinder.rx);
    }
  }

  [[nodiscard]] bool is_axis_parallel() const { return sign(direction.x) == 0 && sign(direction.y) == 0; }

  /// X² + Y² - R² along the line, a quadratic in t; all zero in a where the line is parallel to the axis.
  [[nodiscard]] ExactQuadratic side() const {
    return {direction.x * direction.x + direction.y * direction.y,
            origin.x * direction.x + origin.y * direction.y,
            origin.x * origin.x + origin.y * origin.y - radius * radius};
  }
  /// X² + Y² - R² at t, times the square of t's denominator.
  [[nodiscard]] Ring power_at(const Quotient& t) const {
    const Ring x = origin.x * t.denominator() + direction.x * t.numerator();
    const Ring y = origin.y * t.denominator() + direction.y * t.numerator();
    const Ring r = radius * t.denominator();
    return x * x + y * y - r * r;
  }
  /// z at t, times t's denominator.
  [[nodiscard]] Ring height_at(const Quotient& t) const {
    return origin.z * t.denominator() + direction.z * t.numerator();
  }
  /// z at t.
  [[nodiscard]] ExactRoot height_at(const ExactRoot& t) const {
    return t.affine_image(origin.z, direction.z);
  }
  /// Where the line, not parallel to the caps, meets the plane of one.
  [[nodiscard]] Quotient cap(bool is_lower) const {
    return {is_lower ? -origin.z : height - origin.z, direction.z};
  }
};

}  // namespace rayproof::oracle
