#pragma once
/// \file
/// How far claims are from the exact intersection with an elliptic cylinder.

#include <algorithm>

#include "oracle/geometry/cylinder_equation.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

/// Lengths of the ray's origin (and the cylinder itself) and direction: in the plane in which the side is the
/// unit circle, and along the axis.
struct CylinderSizes {
  Scaled from_axis, across;
  Scaled level, climb;
};

/// The measures of an intersection with a cylinder; the hits are those of the class that derives from it.
class MeasuredCylinder : public ExactIntersection {
 public:
  MeasuredCylinder(const RayQuestion& question, const Cylinder<double>& cylinder)
      : ExactIntersection(question),
        cylinder_(cylinder),
        equation_(ray(), cylinder),
        side_(equation_.side()) {}

  [[nodiscard]] double far() const override { return value(sizes().from_axis); }

  [[nodiscard]] Scaled residual(const Quotient& t) const override { return off_surface(place_at(t)); }
  [[nodiscard]] Scaled off_surface(const Vector<Ring>& point, const Quotient& t) const override {
    const Ring x = point.x * Ring(cylinder_.ry), y = point.y * Ring(cylinder_.rx);
    const Ring power = x * x + y * y - equation_.radius * equation_.radius;
    return off_surface(CylinderPoint{power, point.z, Ring(1.0), t.estimate()});
  }

  /// Of the ray's ends and of the line: of the conditions under which it meets the cylinder, the one that is
  /// broken most, or that holds most narrowly. No less than the ray stays beyond a cap's plane.
  [[nodiscard]] Scaled margin(bool may_merge) const override {
    Scaled nearest = abs(cylinder_.capped ? narrowest_of_solid(may_merge) : narrowest_of_side());
    Scaled beyond;
    for (const double end : finite_ends(question().ray)) {
      reduce(nearest, residual(end));
      const Quotient at(end);
      const Ring z = equation_.height_at(at);
      const int side = sign(z - equation_.height) > 0 ? 1 : std::min(sign(z), 0);
      if (stays_beyond(side * sign(equation_.direction.z), end)) beyond = std::max(beyond, off_caps(at));
    }
    return std::max(nearest, beyond);
  }

 protected:
  [[nodiscard]] const Cylinder<double>& cylinder() const { return cylinder_; }
  [[nodiscard]] const CylinderEquation& equation() const { return equation_; }
  [[nodiscard]] const ExactQuadratic& side() const { return side_; }

  /// A point as the cylinder sees it: X² + Y² - R² there times weight², z times weight, both in the scale of
  /// the equation, and the t that the lengths it is made of go by.
  struct CylinderPoint {
    Ring power, z, weight;
    Scaled t;
  };
  [[nodiscard]] CylinderPoint place_at(const Quotient& t) const {
    return {equation_.power_at(t), equation_.height_at(t), t.denominator(), t.estimate()};
  }
  /// L(t) in the plane in which the side is the unit circle.
  [[nodiscard]] Scaled reach_across(const Scaled& t) const {
    return sizes().from_axis + abs(t) * sizes().across;
  }
  /// How far a point is from the side without an end.
  [[nodiscard]] Scaled off_circle(const CylinderPoint& p) const {
    const Scaled weight = approximate(p.weight);
    return change_of_radius(roughly(p.power) / (weight * weight)) / reach_across(p.t);
  }
  /// How far it is from the plane of a cap.
  [[nodiscard]] Scaled off_cap(const CylinderPoint& p, bool is_lower) const {
    const Scaled gap = abs(roughly(is_lower ? p.z : equation_.height * p.weight - p.z));
    return in_heights(gap / (approximate(ray().scale) * approximate(p.weight)), p.t);
  }

 private:
  /// How far it is from the surface, as far as that reaches.
  [[nodiscard]] Scaled off_surface(const CylinderPoint& p) const {
    const Scaled from_side = off_circle(p), from_cap = std::min(off_cap(p, true), off_cap(p, false));
    const bool is_between_caps = sign(p.z) >= 0 && sign(equation_.height * p.weight - p.z) >= 0;
    const Scaled above = is_between_caps ? Scaled{} : from_cap;
    const Scaled beside = sign(p.power) <= 0 ? Scaled{} : from_side;
    const Scaled to_side = std::max(from_side, above);
    return cylinder_.capped ? std::min(to_side, std::max(from_cap, beside)) : to_side;
  }
  [[nodiscard]] const CylinderSizes& sizes() const {
    if (!sizes_) sizes_ = measured();
    return *sizes_;
  }
  [[nodiscard]] CylinderSizes measured() const {
    const Scaled height(cylinder_.height);
    if (ray().map) {
      const RaySizes<Ring> of_ray(question(), ray());
      const Scaled narrow(std::min(cylinder_.rx, cylinder_.ry));
      return {of_ray.origin / narrow + Scaled(1), of_ray.direction / narrow, of_ray.origin + height,
              of_ray.direction};
    }
    const auto stretched = [&](const Vector<Ring>& v) {
      const Scaled x = approximate(v.x), y = approximate(v.y);
      return sqrt(x * x + y * y) / approximate(equation_.radius);
    };
    return {stretched(equation_.origin) + Scaled(1), stretched(equation_.direction),
            abs(approximate(equation_.origin.z)) + height, abs(approximate(equation_.direction.z))};
  }

  /// The relative change of the radius that puts a point of this power X² + Y² - R² on the circle.
  [[nodiscard]] Scaled change_of_radius(const Scaled& power) const {
    const Scaled radius = approximate(equation_.radius), relative = power / (radius * radius);
    return abs(relative) / far_side(relative, Scaled(1));
  }
  [[nodiscard]] Scaled off_circle(const Quotient& t) const { return off_circle(place_at(t)); }
  [[nodiscard]] Scaled off_caps(const Quotient& t) const {
    const CylinderPoint p = place_at(t);
    return std::min(off_cap(p, true), off_cap(p, false));
  }
  /// A distance along the axis at t in the contract's unit.
  [[nodiscard]] Scaled in_heights(const Scaled& distance, const Scaled& t) const {
    return ratio(distance, sizes().level + abs(t) * sizes().climb);
  }

  /// How far inside the side's infinite cylinder the line comes; negative where it passes it by.
  [[nodiscard]] Scaled depth_of_line() const {
    if (equation_.is_axis_parallel()) {
      const Quotient start(0.0);
      return sign(equation_.power_at(start)) > 0 ? -off_circle(start) : off_circle(start);
    }
    // The line touches a circle whose squared radius is larger by -D/a: the power of its nearest point.
    const Ring discriminant = side_.discriminant();
    const Scaled power = -(approximate(discriminant) / approximate(side_.a));
    const Scaled change = change_of_radius(power) / sizes().from_axis;
    return sign(discriminant) < 0 ? -change : change;
  }
  /// How far inside, seen from a cap's plane, the line meets the side, in the contract's unit; negative
  /// outside. By the height of that hit, or by how far from the rim the line meets the plane nearby,
  /// whichever is less.
  [[nodiscard]] Scaled depth_at_side(const ExactRoot& t, bool is_first, bool is_lower) const {
    const ExactRoot z = equation_.height_at(t);
    const Scaled depth = is_lower ? z.estimate() : -z.affine_image(-equation_.height, Ring(1.0)).estimate();
    Scaled gap = in_heights(abs(depth) / approximate(ray().scale), t.estimate());
    if (sign(equation_.direction.z) != 0) {
      const Quotient plane = equation_.cap(is_lower);
      const int behind_middle = plane.compare(Quotient(-side_.h, side_.a));
      if (is_first ? behind_middle <= 0 : behind_middle >= 0) reduce(gap, off_circle(plane));
    }
    return depth.sign() < 0 ? -gap : gap;
  }

  /// An open cylinder: the hit with the side that is nearest to a rim.
  [[nodiscard]] Scaled narrowest_of_side() const {
    Scaled nearest = abs(depth_of_line());
    if (equation_.is_axis_parallel()) return nearest;
    bool is_first = true;
    for (const ExactRoot& t : real_roots(side_)) {
      reduce(nearest, abs(std::min(depth_at_side(t, is_first, true), depth_at_side(t, is_first, false))));
      is_first = false;
    }
    return nearest;
  }

  /// A capped cylinder: the line comes into the side and between the caps before it leaves either.
  [[nodiscard]] Scaled narrowest_of_solid(bool may_merge) const {
    Scaled narrowest = depth_of_line();
    const int climb = sign(equation_.direction.z);
    if (climb == 0) {
      const Quotient start(0.0);
      const Ring z = equation_.height_at(start);
      const bool is_between = sign(z) >= 0 && sign(equation_.height - z) >= 0;
      reduce(narrowest, is_between ? off_caps(start) : -off_caps(start));
      return narrowest;
    }
    if (equation_.is_axis_parallel()) return narrowest;
    const RootList roots = real_roots(side_);
    if (roots.empty()) return narrowest;
    // Where the line enters the side it has not passed its last cap; where it leaves it, it has passed its
    // first.
    reduce(narrowest, depth_at_side(roots.front(), true, climb < 0));
    reduce(narrowest, depth_at_side(roots.back(), false, climb > 0));
    if (may_merge && cylinder_.height > 0)
      reduce(narrowest, in_heights(Scaled(cylinder_.height), equation_.cap(true).estimate()));
    return narrowest;
  }

  const Cylinder<double>& cylinder_;
  CylinderEquation equation_;
  ExactQuadratic side_;
  mutable std::optional<CylinderSizes> sizes_;
};

}  // namespace rayproof::oracle
