/// \file
/// The oracle for ray and elliptic cylinder.

#include "oracle/shapes/cylinder/measures.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

class CylinderIntersection final : public MeasuredCylinder {
 public:
  using MeasuredCylinder::MeasuredCylinder;

  [[nodiscard]] ExactContacts hits() const override {
    // Convex with its caps: what goes in through a cap does so before it meets the side, and the other way
    // out. The two caps of a cylinder of no height are one.
    ExactContacts all;
    add_cap(all, true);
    add_side(all);
    if (cylinder().height > 0) add_cap(all, false);
    return all;
  }

  /// Whether the line runs inside an open cylinder's side.
  [[nodiscard]] Contact miss() const override {
    const bool has_side = !cylinder().capped && cylinder().height > 0;
    const bool is_inside_side = has_side && equation().is_axis_parallel() && sign(side().c) == 0;
    return is_inside_side ? Contact::in_surface : Contact::none;
  }

  /// None on a rim, and none of a cylinder of no height: both its caps are in one plane, and neither is
  /// outward.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact& hit) const override {
    if (hit.contact == Contact::rim) return std::nullopt;
    if (const auto* t = std::get_if<Quotient>(&hit.t)) {
      if (cylinder().height == 0) return std::nullopt;
      const bool is_lower = sign(equation().height_at(*t)) == 0;
      return ExactNormal{{Ring(0.0), Ring(0.0), Ring(is_lower ? -1.0 : 1.0)}};
    }
    return side_normal();
  }

  /// The side, and the caps where there are any, each as if it had no end.
  [[nodiscard]] SurfaceParts parts(const Quotient& t, const Scaled& roundoff) const override {
    SurfaceParts all;
    const CylinderPoint p = place_at(t);
    if (const auto condition = condition_of_side(t, roundoff))
      all.push_back({side_normal(), off_circle(p), *condition});
    if (!cylinder().capped) return all;
    for (const bool is_lower : {true, false})
      all.push_back({{{Ring(0.0), Ring(0.0), Ring(is_lower ? -1.0 : 1.0)}}, off_cap(p, is_lower), Scaled(1)});
    return all;
  }

 private:
  /// Outward: the gradient (ry²·x, rx²·y, 0) of the side's equation.
  [[nodiscard]] ExactNormal side_normal() const {
    const auto gradient = [&](const Vector<Ring>& v) {
      return Vector<Ring>{v.x * Ring(cylinder().ry), v.y * Ring(cylinder().rx), Ring(0.0)};
    };
    return {gradient(equation().origin), gradient(equation().direction)};
  }
  /// By how much the rounding of p(t), in the plane in which the side is the unit circle, may turn the side's
  /// normal, in units of ε: K of cylinder.hpp, where it is derived. Nothing on the axis, where there is none.
  [[nodiscard]] std::optional<Scaled> condition_of_side(const Quotient& t, const Scaled& roundoff) const {
    const Scaled reach = reach_across(t.estimate());
    const Scaled weight = approximate(t.denominator()) * abs(approximate(equation().radius));
    const auto across = [&](const Ring& o, const Ring& d) {
      return abs(approximate(o * t.denominator() + d * t.numerator())) / weight;
    };
    const Scaled x = across(equation().origin.x, equation().direction.x);
    const Scaled y = across(equation().origin.y, equation().direction.y);
    if (x.sign() == 0 && y.sign() == 0) return std::nullopt;
    // As near to the axis as rounding may bring each coordinate.
    const Scaled off = Scaled(ray().map ? 8 : 2) * roundoff * reach;
    const Scaled near_x = std::max(x - off, Scaled{}), near_y = std::max(y - off, Scaled{});
    // The normal is (x/rx, y/ry); its turn by a step of δ is at most δ·|(x, y)|/(rx·ry·|normal|²).
    const Scaled flatness = Scaled(cylinder().ry) / Scaled(cylinder().rx);
    const Scaled squared_normal = near_x * near_x * flatness + near_y * near_y / flatness;
    if (squared_normal.sign() == 0) return endless();
    return Scaled(1) + reach * sqrt(x * x + y * y) / squared_normal;
  }

  /// The hit with the cap's plane that the line passes on its way in, or out, where it lies inside the rim.
  /// (On the rim it is the side's hit, unless the line runs inside the side.)
  void add_cap(ExactContacts& hits, bool of_entry) const {
    const bool is_ring = cylinder().height == 0;  // an open cylinder of no height is all rim
    const int climb = sign(equation().direction.z);
    if (!(cylinder().capped || is_ring) || climb == 0) return;
    const Quotient t = equation().cap((climb > 0) == of_entry);
    const int outside = sign(equation().power_at(t));
    const bool is_rim_of_own = outside == 0 && equation().is_axis_parallel();
    if (is_rim_of_own || (cylinder().capped && outside < 0))
      add(hits, t, is_rim_of_own ? Contact::rim : Contact::crossing);
  }

  void add_side(ExactContacts& hits) const {
    if (equation().is_axis_parallel()) return;
    RootList roots = real_roots(side());
    const Contact off_rim = roots.size() == 1 ? Contact::tangent : Contact::crossing;
    for (ExactRoot& t : roots) {
      const ExactRoot z = equation().height_at(t);
      const int above_floor = z.compare(Ring(0.0)), above_top = z.compare(equation().height);
      if (above_floor < 0 || above_top > 0) continue;
      const bool is_on_rim = above_floor == 0 || above_top == 0;
      add(hits, std::move(t), is_on_rim ? Contact::rim : off_rim);
    }
  }
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Cylinder<double>& cylinder) {
  return std::make_unique<CylinderIntersection>(question, cylinder);
}

}  // namespace rayproof::oracle
