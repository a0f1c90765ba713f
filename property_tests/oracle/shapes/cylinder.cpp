/// \file
/// The oracle for ray and elliptic cylinder.

#include <algorithm>

#include "oracle/geometry/cylinder_equation.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// Lengths of the ray's origin (and the cylinder itself) and direction: in the plane in which the side is the
/// unit circle, and along the axis.
struct CylinderSizes {
  Scaled from_axis, across;
  Scaled level, climb;
};

class CylinderIntersection final : public ExactIntersection {
 public:
  CylinderIntersection(const RayQuestion& question, const Cylinder<double>& cylinder)
      : ExactIntersection(question),
        cylinder_(cylinder),
        equation_(ray(), cylinder),
        side_(equation_.side()) {}

  [[nodiscard]] ExactContacts hits() const override {
    // Convex with its caps: what goes in through a cap does so before it meets the side, and the other way
    // out. The two caps of a cylinder of no height are one.
    ExactContacts all;
    add_cap(all, true);
    add_side(all);
    if (cylinder_.height > 0) add_cap(all, false);
    return all;
  }

  /// Whether the line runs inside an open cylinder's side.
  [[nodiscard]] Contact miss() const override {
    const bool has_side = !cylinder_.capped && cylinder_.height > 0;
    const bool is_inside_side = has_side && equation_.is_axis_parallel() && sign(side_.c) == 0;
    return is_inside_side ? Contact::in_surface : Contact::none;
  }

  /// None on a rim, and none of a cylinder of no height: both its caps are in one plane, and neither is
  /// outward.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact& hit) const override {
    if (hit.contact == Contact::rim) return std::nullopt;
    if (const auto* t = std::get_if<Quotient>(&hit.t)) {
      if (cylinder_.height == 0) return std::nullopt;
      const bool is_lower = sign(equation_.height_at(*t)) == 0;
      return ExactNormal{{Ring(0.0), Ring(0.0), Ring(is_lower ? -1.0 : 1.0)}};
    }
    // The side's outward normal is the gradient (ry²·x, rx²·y, 0) of its equation.
    const auto gradient = [&](const Vector<Ring>& v) {
      return Vector<Ring>{v.x * Ring(cylinder_.ry), v.y * Ring(cylinder_.rx), Ring(0.0)};
    };
    return ExactNormal{gradient(equation_.origin), gradient(equation_.direction)};
  }

  [[nodiscard]] double far() const override { return value(sizes().from_axis); }

  [[nodiscard]] Scaled residual(double t) const override {
    const Quotient at(t);
    const Scaled from_side = off_circle(at), from_cap = off_caps(at);
    const Ring z = equation_.height_at(at);
    const bool is_between_caps = sign(z) >= 0 && sign(equation_.height - z) >= 0;
    const Scaled above = is_between_caps ? Scaled{} : from_cap;
    const Scaled beside = sign(equation_.power_at(at)) <= 0 ? Scaled{} : from_side;
    const Scaled to_side = std::max(from_side, above);
    return cylinder_.capped ? std::min(to_side, std::max(from_cap, beside)) : to_side;
  }

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = endless();
    std::vector<double> places = finite_ends(question().ray);
    places.push_back(0);  // for a line that is parallel to the axis or to the caps
    for (const Quotient at : places) reduce(nearest, std::min(off_circle(at), off_caps(at)));
    if (sign(equation_.direction.z) != 0) {
      for (const bool is_lower : {true, false}) {
        const Quotient t = equation_.cap(is_lower);
        reduce(nearest, off_circle(t));
        reduce(nearest, in_heights(Scaled(cylinder_.height), t.estimate()));  // two caps met at one t
      }
    }
    if (!equation_.is_axis_parallel()) reduce_by_roots(nearest);
    return nearest;
  }

 private:
  /// The hit with the cap's plane that the line passes on its way in, or out, where it lies inside the rim.
  /// (On the rim it is the side's hit, unless the line runs inside the side.)
  void add_cap(ExactContacts& hits, bool of_entry) const {
    const bool is_ring = cylinder_.height == 0;  // an open cylinder of no height is all rim
    const int climb = sign(equation_.direction.z);
    if (!(cylinder_.capped || is_ring) || climb == 0) return;
    const Quotient t = equation_.cap((climb > 0) == of_entry);
    const int outside = sign(equation_.power_at(t));
    const bool is_rim_of_own = outside == 0 && equation_.is_axis_parallel();
    if (is_rim_of_own || (cylinder_.capped && outside < 0))
      add(hits, t, is_rim_of_own ? Contact::rim : Contact::crossing);
  }

  void add_side(ExactContacts& hits) const {
    if (equation_.is_axis_parallel()) return;
    RootList roots = real_roots(side_);
    const Contact off_rim = roots.size() == 1 ? Contact::tangent : Contact::crossing;
    for (ExactRoot& t : roots) {
      const ExactRoot z = equation_.height_at(t);
      const int above_floor = z.compare(Ring(0.0)), above_top = z.compare(equation_.height);
      if (above_floor < 0 || above_top > 0) continue;
      const bool is_on_rim = above_floor == 0 || above_top == 0;
      add(hits, std::move(t), is_on_rim ? Contact::rim : off_rim);
    }
  }

  [[nodiscard]] const CylinderSizes& sizes() const {
    if (!sizes_) sizes_ = measured();
    return *sizes_;
  }
  [[nodiscard]] CylinderSizes measured() const {
    const Scaled height(cylinder_.height);
    if (ray().map) {
      const RaySizes of_ray(question(), ray());
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
  [[nodiscard]] Scaled off_circle(const Quotient& t) const {
    const Scaled denominator = approximate(t.denominator());
    const Scaled change = change_of_radius(approximate(equation_.power_at(t)) / (denominator * denominator));
    return change / (sizes().from_axis + abs(t.estimate()) * sizes().across);
  }

  [[nodiscard]] Scaled off_caps(const Quotient& t) const {
    const Ring z = equation_.height_at(t);
    const Scaled low = abs(approximate(z)), high = abs(approximate(equation_.height * t.denominator() - z));
    const Scaled scale = approximate(ray().scale) * approximate(t.denominator());
    return in_heights(std::min(low, high) / scale, t.estimate());
  }
  /// A distance along the axis at t in the contract's unit.
  [[nodiscard]] Scaled in_heights(const Scaled& distance, const Scaled& t) const {
    return ratio(distance, sizes().level + abs(t) * sizes().climb);
  }

  void reduce_by_roots(Scaled& nearest) const {
    // The line touches a circle whose squared radius is larger by -D/a: the power of its nearest point.
    const Scaled power = -(approximate(side_.discriminant()) / approximate(side_.a));
    reduce(nearest, change_of_radius(power) / sizes().from_axis);
    for (const ExactRoot& t : real_roots(side_)) {
      const ExactRoot z = equation_.height_at(t);
      const Scaled top = z.affine_image(-equation_.height, Ring(1.0)).estimate();
      const Scaled distance = std::min(abs(z.estimate()), abs(top)) / approximate(ray().scale);
      reduce(nearest, in_heights(distance, t.estimate()));
    }
  }

  const Cylinder<double>& cylinder_;
  CylinderEquation equation_;
  ExactQuadratic side_;
  mutable std::optional<CylinderSizes> sizes_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Cylinder<double>& cylinder) {
  return std::make_unique<CylinderIntersection>(question, cylinder);
}

}  // namespace rayproof::oracle
