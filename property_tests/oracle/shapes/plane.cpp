/// \file
/// The oracle for ray and plane, in its three forms.

#include "oracle/shapes/estimated.hpp"
#include "oracle/shapes/flat_meeting.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

template <class Size, class Plane>
Size position_of(const Plane& plane) {
  if constexpr (requires { plane.point; })
    return Size(length_of(plane.point));
  else
    return Size(std::abs(plane.d)) / Size(length_of(plane.normal));
}
template <class Size, class Plane>
Size normal_size_of(const Plane& plane) {
  if constexpr (requires { plane.normal; })
    return Size(length_of(plane.normal));
  else
    return Size(length_of(plane.u)) * Size(length_of(plane.v));
}

/// As the quick judge sees it.
template <class Plane>
class PlaneMeeting : public FlatMeeting {
 public:
  PlaneMeeting(const RayQuestion& question, const Plane& plane)
      : FlatMeeting(question, equation_of<Estimate>(plane)), plane_(plane) {}

  [[nodiscard]] auto hits() const {
    return hits_where([](const auto& /*t*/) { return Contact::crossing; });
  }
  void measure() { measure_by(position_of<long double>(plane_), normal_size_of<long double>(plane_)); }
  [[nodiscard]] double far() const { return 1; }

 private:
  const Plane& plane_;
};

template <class Plane>
class PlaneIntersection final : public FlatIntersection {
 public:
  PlaneIntersection(const RayQuestion& question, const Plane& plane)
      : FlatIntersection(question, equation_of<Ring>(plane)), plane_(plane) {}

  /// From where the line meets the plane: as seen from the given point, its products with u and v along the
  /// normal.
  [[nodiscard]] std::optional<std::array<Quotient, 2>> parameters() const override {
    if constexpr (requires { plane_.u; }) {
      if (is_parallel()) return std::nullopt;
      const Quotient at = t();
      const Ring& weight = at.denominator();
      const Vector<Ring> place = weight * from_point() + at.numerator() * ray().direction;
      const Ring whole = weight * ray().scale * dot(plane_normal(), plane_normal());
      const auto u = Vector<Ring>::from(plane_.u), v = Vector<Ring>::from(plane_.v);
      return std::array{Quotient(dot(cross(place, v), plane_normal()), whole),
                        Quotient(dot(cross(u, place), plane_normal()), whole)};
    }
    return std::nullopt;
  }
  /// How large the volumes may be of which they are quotients, over the least that rounding leaves of the
  /// divisor.
  [[nodiscard]] Scaled condition_of_coordinates(const Scaled& roundoff) const override {
    if constexpr (requires { plane_.u; }) {
      const auto [alpha, beta] = *parameters();
      const Scaled u = norm(plane_.u), v = norm(plane_.v), scale = approximate(ray().scale);
      const Scaled origin = ray().map ? scale * sizes().origin : norm(from_point());
      const Scaled reach = origin + scale * (abs(alpha.estimate()) * u + abs(beta.estimate()) * v);
      const Scaled divisor = steepness() - Scaled(ray().map ? 24 : 6) * roundoff;
      if (divisor.sign() <= 0) return endless();
      return reach * std::max(u, v) / (scale * divisor * size_of_products());
    }
    return Scaled(1);
  }

 protected:
  [[nodiscard]] Scaled position() const override { return position_of<Scaled>(plane_); }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    return {normal_size_of<Scaled>(plane_)};
  }

 private:
  /// The ray's origin as seen from the given point, in the scale of ObjectRay.
  [[nodiscard]] Vector<Ring> from_point() const {
    return ray().origin - ray().scale * Vector<Ring>::from(plane_.point);
  }

  const Plane& plane_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const ImplicitPlane& plane) {
  return std::make_unique<PlaneIntersection<ImplicitPlane>>(question, plane);
}
ExactPointer intersection_of(const RayQuestion& question, const PointNormalPlane& plane) {
  return std::make_unique<PlaneIntersection<PointNormalPlane>>(question, plane);
}
ExactPointer intersection_of(const RayQuestion& question, const ParametricPlane& plane) {
  return std::make_unique<PlaneIntersection<ParametricPlane>>(question, plane);
}

Judgement judge(const RayQuestion& question, const ImplicitPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<PlaneMeeting<ImplicitPlane>>(question, plane, precision, claimed);
}
Judgement judge(const RayQuestion& question, const PointNormalPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<PlaneMeeting<PointNormalPlane>>(question, plane, precision, claimed);
}
Judgement judge(const RayQuestion& question, const ParametricPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<PlaneMeeting<ParametricPlane>>(question, plane, precision, claimed);
}

}  // namespace rayproof::oracle
