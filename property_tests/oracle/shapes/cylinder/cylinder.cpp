/// \file
/// The oracle for ray and elliptic cylinder.

#include "oracle/shapes/cylinder/measures.hpp"
#include "oracle/shapes/estimated.hpp"

namespace rayproof::oracle {
namespace {

/// As the quick judge sees it.
class CylinderMeeting {
 public:
  CylinderMeeting(const RayQuestion& question, const Cylinder<double>& cylinder)
      : question_(question), cylinder_(cylinder), ray_(question), equation_(ray_, cylinder) {}

  [[nodiscard]] const ObjectRay<Estimate>& ray() const { return ray_; }
  [[nodiscard]] auto hits() const { return CylinderHits(equation_, cylinder_, question_.ray)(); }
  void measure() { sizes_.emplace(question_, ray_, equation_, cylinder_); }
  [[nodiscard]] double far() const { return value(sizes_->from_axis); }
  [[nodiscard]] long double residual(double t) const {
    return off_surface(CylinderPoint<Estimate>(equation_, t), cylinder_.capped, equation_, *sizes_);
  }

 private:
  const RayQuestion& question_;
  const Cylinder<double>& cylinder_;
  ObjectRay<Estimate> ray_;
  CylinderEquation<Estimate> equation_;
  std::optional<CylinderSizes<Estimate>> sizes_;
};

class CylinderIntersection final : public MeasuredCylinder {
 public:
  using MeasuredCylinder::MeasuredCylinder;

  [[nodiscard]] ExactContacts hits() const override {
    return CylinderHits(equation(), cylinder(), question().ray)();
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
    const CylinderPoint<Ring> p = place_at(t);
    // On the axis the side has no normal, and each of its normals is as good there.
    const Ring radius = equation().radius * p.weight;
    const bool is_on_axis = sign(p.power + radius * radius) == 0;
    const ExactNormal any{{Ring(1.0), Ring(0.0), Ring(0.0)}};
    all.push_back({is_on_axis ? any : side_normal(), off_circle(p), condition_of_side(t, roundoff)});
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
  /// normal, in units of ε: K of cylinder.hpp, where it is derived.
  [[nodiscard]] Scaled condition_of_side(const Quotient& t, const Scaled& roundoff) const {
    const Scaled reach = sizes().reach_across(t.estimate());
    const Scaled weight = approximate(t.denominator()) * abs(approximate(equation().radius));
    const auto across = [&](const Ring& o, const Ring& d) {
      return abs(approximate(o * t.denominator() + d * t.numerator())) / weight;
    };
    const Scaled x = across(equation().origin.x, equation().direction.x);
    const Scaled y = across(equation().origin.y, equation().direction.y);
    // As near to the axis as rounding may bring each coordinate.
    const Scaled off = Scaled(ray().map ? 8 : 2) * roundoff * reach;
    const Scaled near_x = std::max(x - off, Scaled{}), near_y = std::max(y - off, Scaled{});
    // The normal is (x/rx, y/ry); its turn by a step of δ is at most δ·|(x, y)|/(rx·ry·|normal|²).
    const Scaled flatness = Scaled(cylinder().ry) / Scaled(cylinder().rx);
    const Scaled squared_normal = near_x * near_x * flatness + near_y * near_y / flatness;
    if (squared_normal.sign() == 0) return endless();
    return Scaled(1) + reach * sqrt(x * x + y * y) / squared_normal;
  }
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Cylinder<double>& cylinder) {
  return std::make_unique<CylinderIntersection>(question, cylinder);
}

Judgement judge(const RayQuestion& question, const Cylinder<double>& cylinder, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<CylinderMeeting>(question, cylinder, precision, claimed);
}

}  // namespace rayproof::oracle
