#pragma once
/// \file
/// How far claims are from the exact intersection with an elliptic cylinder.

#include "oracle/shapes/cylinder/distances.hpp"

namespace rayproof::oracle {

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
    return off_surface(CylinderPoint<Ring>(equation_, cylinder_, point, t));
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
  [[nodiscard]] const CylinderEquation<Ring>& equation() const { return equation_; }
  [[nodiscard]] const ExactQuadratic& side() const { return side_; }

  [[nodiscard]] CylinderPoint<Ring> place_at(const Quotient& t) const { return {equation_, t}; }
  [[nodiscard]] const CylinderSizes<Ring>& sizes() const {
    if (!sizes_) sizes_.emplace(question(), ray(), equation_, cylinder_);
    return *sizes_;
  }
  [[nodiscard]] Scaled off_circle(const CylinderPoint<Ring>& p) const {
    return oracle::off_circle(p, sizes());
  }
  [[nodiscard]] Scaled off_cap(const CylinderPoint<Ring>& p, bool is_lower) const {
    return oracle::off_cap(p, is_lower, equation_, sizes());
  }

 private:
  [[nodiscard]] Scaled off_surface(const CylinderPoint<Ring>& p) const {
    return oracle::off_surface(p, cylinder_.capped, equation_, sizes());
  }
  [[nodiscard]] Scaled off_circle(const Quotient& t) const { return off_circle(place_at(t)); }
  [[nodiscard]] Scaled off_caps(const Quotient& t) const {
    const CylinderPoint<Ring> p = place_at(t);
    return std::min(off_cap(p, true), off_cap(p, false));
  }

  /// How far inside the side's infinite cylinder the line comes; negative where it passes it by.
  [[nodiscard]] Scaled depth_of_line() const {
    if (ray().map && sign(equation_.direction.z) != 0) return depth_of_mapped_line();
    if (equation_.is_axis_parallel()) {
      const Quotient start(0.0);
      return sign(equation_.power_at(start)) > 0 ? -off_circle(start) : off_circle(start);
    }
    return depth_in(sizes().from_axis);
  }
  /// The same of a line that is not parallel to the axis, as a share of a length. The line touches a circle
  /// whose squared radius is larger by -D/a: the power of its nearest point.
  [[nodiscard]] Scaled depth_in(const Scaled& reach) const {
    const Ring discriminant = side_.discriminant();
    const Scaled power = -(approximate(discriminant) / approximate(side_.a));
    const Scaled change = sizes().change_of_radius(power) / reach;
    return sign(discriminant) < 0 ? -change : change;
  }
  /// The same under a transform. That rounds the direction, and moves p(t) by the more the larger t is: much,
  /// where the line comes by far from the ray's origin, or nearly along the axis. Only between the heights
  /// does it matter.
  [[nodiscard]] Scaled depth_of_mapped_line() const {
    const Quotient bottom = equation_.cap(true), top = equation_.cap(false);
    const bool is_upward = sign(equation_.direction.z) > 0;
    const Quotient &entry = is_upward ? bottom : top, &exit = is_upward ? top : bottom;
    const Scaled off_ends = std::min(off_circle(entry), off_circle(exit));
    if (equation_.is_axis_parallel()) return sign(equation_.power_at(entry)) > 0 ? -off_ends : off_ends;
    const Quotient nearest(-side_.h, side_.a);
    const Quotient& between = nearest.compare(entry) < 0 ? entry : nearest.compare(exit) > 0 ? exit : nearest;
    const Scaled depth = depth_in(sizes().reach_across(between.estimate()));
    return depth.sign() < 0 ? -std::min(off_ends, off_circle(between)) : depth;
  }
  /// How far inside, seen from a cap's plane, the line meets the side, in the contract's unit; negative
  /// outside. By the height of that hit, or by how far from the rim the line meets the plane nearby,
  /// whichever is less.
  [[nodiscard]] Scaled depth_at_side(const ExactRoot& t, bool is_first, bool is_lower) const {
    const ExactRoot z = equation_.height_at(t);
    const Scaled depth = is_lower ? z.estimate() : -z.affine_image(-equation_.height, Ring(1.0)).estimate();
    Scaled gap = sizes().in_heights(abs(depth) / approximate(ray().scale), t.estimate());
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
    if (may_merge && cylinder_.height > 0)
      reduce(narrowest, sizes().in_heights(Scaled(cylinder_.height), equation_.cap(true).estimate()));
    const RootList roots = equation_.is_axis_parallel() ? RootList{} : real_roots(side_);
    if (roots.empty()) return narrowest;
    // Where the line enters the side it has not passed its last cap; where it leaves it, it has passed its
    // first.
    reduce(narrowest, depth_at_side(roots.front(), true, climb < 0));
    reduce(narrowest, depth_at_side(roots.back(), false, climb > 0));
    return narrowest;
  }

  const Cylinder<double>& cylinder_;
  CylinderEquation<Ring> equation_;
  ExactQuadratic side_;
  mutable std::optional<CylinderSizes<Ring>> sizes_;
};

}  // namespace rayproof::oracle
