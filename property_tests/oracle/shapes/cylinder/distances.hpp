#pragma once
/// \file
/// How far a point is from the surface of an elliptic cylinder, in the units of the contracts.

#include <algorithm>

#include "oracle/geometry/cylinder_equation.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

/// Lengths of the ray's origin (and the cylinder itself) and direction: in the plane in which the side is the
/// unit circle, and along the axis.
template <class R>
struct CylinderSizes {
  using Size = SizeOf<R>;

  Size from_axis, across;
  Size level, climb;
  Size scale, radius;  ///< of ObjectRay; of the equation

  CylinderSizes(const RayQuestion& question, const ObjectRay<R>& ray, const CylinderEquation<R>& equation,
                const Cylinder<double>& cylinder)
      : scale(approximate(ray.scale)), radius(approximate(equation.radius)) {
    using std::abs, std::sqrt;
    const Size height(cylinder.height);
    if (ray.map) {
      const RaySizes<R> of_ray(question, ray);
      const Size narrow(std::min(cylinder.rx, cylinder.ry));
      from_axis = of_ray.origin / narrow + Size(1);
      across = of_ray.direction / narrow;
      level = of_ray.origin + height;
      climb = of_ray.direction;
      return;
    }
    const auto stretched = [&](const Vector<R>& v) {
      const Size x = approximate(v.x), y = approximate(v.y);
      return sqrt(x * x + y * y) / radius;
    };
    from_axis = stretched(equation.origin) + Size(1);
    across = stretched(equation.direction);
    level = abs(approximate(equation.origin.z)) + height;
    climb = abs(approximate(equation.direction.z));
  }

  /// L(t) in the plane in which the side is the unit circle.
  [[nodiscard]] Size reach_across(const Size& t) const {
    using std::abs;
    return from_axis + abs(t) * across;
  }
  /// A distance along the axis at t in the contract's unit.
  [[nodiscard]] Size in_heights(const Size& distance, const Size& t) const {
    using std::abs;
    return ratio(distance, level + abs(t) * climb);
  }
  /// The relative change of the radius that puts a point of this power X² + Y² - R² on the circle.
  [[nodiscard]] Size change_of_radius(const Size& power) const {
    using std::abs;
    const Size relative = power / (radius * radius);
    return abs(relative) / far_side(relative, Size(1));
  }
};

/// A point as the cylinder sees it: X² + Y² - R² there times weight², z times weight, both in the scale of
/// the equation, and the t that the lengths it is made of go by.
template <class R>
struct CylinderPoint {
  R power, z, weight;
  SizeOf<R> t;

  CylinderPoint(const CylinderEquation<R>& equation, const QuotientOf<R>& at)
      : power(equation.power_at(at)), z(equation.height_at(at)), weight(at.denominator()), t(at.estimate()) {}
  /// The point itself, of weight 1, in the scale of ObjectRay.
  CylinderPoint(const CylinderEquation<R>& equation, const Cylinder<double>& cylinder, const Vector<R>& point,
                const QuotientOf<R>& at)
      : z(point.z), weight(1.0), t(at.estimate()) {
    const R x = point.x * R(cylinder.ry), y = point.y * R(cylinder.rx);
    power = x * x + y * y - equation.radius * equation.radius;
  }
};

/// How far a point is from the side without an end.
template <class R>
[[nodiscard]] SizeOf<R> off_circle(const CylinderPoint<R>& p, const CylinderSizes<R>& sizes) {
  const SizeOf<R> weight = approximate(p.weight);
  return sizes.change_of_radius(roughly(p.power) / (weight * weight)) / sizes.reach_across(p.t);
}

/// How far it is from the plane of a cap.
template <class R>
[[nodiscard]] SizeOf<R> off_cap(const CylinderPoint<R>& p, bool is_lower, const CylinderEquation<R>& equation,
                                const CylinderSizes<R>& sizes) {
  using std::abs;
  const SizeOf<R> gap = abs(roughly(is_lower ? p.z : equation.height * p.weight - p.z));
  return sizes.in_heights(gap / (sizes.scale * approximate(p.weight)), p.t);
}

/// How far it is from the surface, as far as that reaches.
template <class R>
[[nodiscard]] SizeOf<R> off_surface(const CylinderPoint<R>& p, bool is_capped,
                                    const CylinderEquation<R>& equation, const CylinderSizes<R>& sizes) {
  using Size = SizeOf<R>;
  const Size from_side = off_circle(p, sizes);
  const Size from_cap = std::min(off_cap(p, true, equation, sizes), off_cap(p, false, equation, sizes));
  const bool is_between_caps = sign(p.z) >= 0 && sign(equation.height * p.weight - p.z) >= 0;
  const Size above = is_between_caps ? Size{} : from_cap;
  const Size beside = sign(p.power) <= 0 ? Size{} : from_side;
  const Size to_side = std::max(from_side, above);
  return is_capped ? std::min(to_side, std::max(from_cap, beside)) : to_side;
}

}  // namespace rayproof::oracle
