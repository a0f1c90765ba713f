/// \file
/// The judge for elliptic cylinders.

#include <algorithm>

#include "oracle/geometry/cylinder_equation.hpp"
#include "oracle/judge/judging.hpp"
#include "oracle/shapes/cylinder.hpp"

namespace rayproof::oracle {
namespace {

class CylinderFigure final : public Figure {
 public:
  CylinderFigure(const RayQuestion& question, const Cylinder<double>& cylinder)
      : question_(question),
        ray_(question),
        equation_(ray_, cylinder),
        side_(equation_.side()),
        sizes_(question, ray_),
        radius_(abs(approximate(equation_.radius))),
        height_(cylinder.height) {
    if (ray_.map) {
      const Scaled narrow(std::min(cylinder.rx, cylinder.ry));
      from_axis_ = sizes_.origin / narrow + Scaled(1);
      across_ = sizes_.direction / narrow;
      level_ = sizes_.origin;
      climb_ = sizes_.direction;
    } else {
      const auto stretched = [&](const Vector<Ring>& v) {
        const Scaled x = approximate(v.x), y = approximate(v.y);
        return sqrt(x * x + y * y) / radius_;
      };
      from_axis_ = stretched(equation_.origin) + Scaled(1);
      across_ = stretched(equation_.direction);
      level_ = abs(approximate(equation_.origin.z));
      climb_ = abs(approximate(equation_.direction.z));
    }
  }

  [[nodiscard]] std::vector<ExactNumber> hits() const override {
    std::vector<ExactNumber> all;
    for (const CylinderHit& hit : equation_.hits()) {
      std::visit(
          [&](const auto& t) {
            if (is_in_interval(t, question_.ray)) all.emplace_back(t);
          },
          hit.t);
    }
    return all;
  }

  [[nodiscard]] double far() const override { return static_cast<double>(from_axis_.value()); }

  [[nodiscard]] Scaled residual(double t) const override {
    const Quotient at(Ring(t), Ring(1.0));
    const Scaled from_side = off_circle(at), from_cap = off_caps(at);
    const Scaled above = is_between_caps(at) ? Scaled{} : from_cap;
    const Scaled beside = is_within_circle(at) ? Scaled{} : from_side;
    const Scaled to_side = std::max(from_side, above);
    return equation_.capped ? std::min(to_side, std::max(from_cap, beside)) : to_side;
  }

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = endless();
    std::vector<double> places = finite_ends(question_.ray);
    places.push_back(0);  // for a line that is parallel to the axis or to the caps
    for (const double end : places) {
      const Quotient at(Ring(end), Ring(1.0));
      reduce(nearest, off_circle(at));
      reduce(nearest, off_caps(at));
    }
    if (sign(equation_.direction.z) != 0) {
      for (const Ring& cap : {Ring(0.0), equation_.height}) {
        const Quotient t(cap - equation_.origin.z, equation_.direction.z);
        reduce(nearest, off_circle(t));
        reduce(nearest, ratio(height_, level() + abs(t.estimate()) * climb()));  // two caps met at one t
      }
    }
    if (!equation_.is_axis_parallel()) reduce_by_roots(nearest);
    return nearest;
  }

 private:
  /// The relative change of the radius that puts a point of this power X² + Y² - R² on the circle.
  [[nodiscard]] Scaled change_of_radius(const Scaled& power) const {
    const Scaled relative = power / (radius_ * radius_);
    const Scaled distance = sqrt(abs(Scaled(1) + relative));
    return abs(relative) / (distance + Scaled(1));
  }
  [[nodiscard]] Ring power_at(const Quotient& t) const {
    const Ring x = equation_.origin.x * t.denominator() + equation_.direction.x * t.numerator();
    const Ring y = equation_.origin.y * t.denominator() + equation_.direction.y * t.numerator();
    const Ring r = equation_.radius * t.denominator();
    return x * x + y * y - r * r;
  }
  [[nodiscard]] bool is_within_circle(const Quotient& t) const { return sign(power_at(t)) <= 0; }
  [[nodiscard]] Scaled off_circle(const Quotient& t) const {
    const Scaled denominator = approximate(t.denominator());
    const Scaled change = change_of_radius(approximate(power_at(t)) / (denominator * denominator));
    return change / (from_axis_ + abs(t.estimate()) * across_);
  }

  [[nodiscard]] Ring height_at(const Quotient& t) const {
    return equation_.origin.z * t.denominator() + equation_.direction.z * t.numerator();
  }
  [[nodiscard]] bool is_between_caps(const Quotient& t) const {
    const Ring z = height_at(t);
    return sign(z) >= 0 && sign(equation_.height * t.denominator() - z) >= 0;
  }
  [[nodiscard]] Scaled off_caps(const Quotient& t) const {
    const Scaled scale = abs(approximate(ray_.scale)) * approximate(t.denominator());
    const Ring z = height_at(t);
    const Scaled low = abs(approximate(z)) / scale;
    const Scaled high = abs(approximate(equation_.height * t.denominator() - z)) / scale;
    return ratio(std::min(low, high), level() + abs(t.estimate()) * climb());
  }
  [[nodiscard]] Scaled level() const { return level_ + height_; }
  [[nodiscard]] Scaled climb() const { return climb_; }

  void reduce_by_roots(Scaled& nearest) const {
    const Ring D = side_.discriminant();
    // The line touches a circle whose squared radius is larger by -D/a: the power of its nearest point.
    reduce(nearest, change_of_radius(-(approximate(D) / approximate(side_.a))) / from_axis_);
    if (sign(D) < 0) return;
    for (const int which : {-1, 1}) {
      const ExactRoot t(side_, which);
      const ExactRoot z = t.affine_image(equation_.origin.z, equation_.direction.z);
      const Scaled scale = abs(approximate(ray_.scale));
      const Scaled top = z.affine_image(-equation_.height, Ring(1.0)).estimate();
      const Scaled distance = std::min(abs(z.estimate()), abs(top)) / scale;
      reduce(nearest, ratio(distance, level() + abs(t.estimate()) * climb()));
    }
  }

  const RayQuestion& question_;
  ObjectRay<Ring> ray_;
  CylinderEquation equation_;
  ExactQuadratic side_;
  RaySizes sizes_;
  Scaled radius_, height_;
  Scaled from_axis_, across_;  ///< of origin and direction, in the plane in which the side is the unit circle
  Scaled level_, climb_;       ///< of origin and direction, along the axis
};

}  // namespace

Judgement judge(const RayQuestion& question, const Cylinder<double>& cylinder, Precision precision,
                const RayAnswer& claimed) {
  return judge_hits(question, CylinderFigure(question, cylinder), precision, claimed);
}

}  // namespace rayproof::oracle
