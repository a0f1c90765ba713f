/// \file
/// The oracle for ray and plane, in its three forms.

#include "oracle/shapes/flat.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

FlatEquation equation_of(const ImplicitPlane& plane) {
  return {Vector<Ring>::from(plane.normal), Ring(-plane.d)};
}
FlatEquation equation_of(const PointNormalPlane& plane) {
  return plane_through(plane.point, Vector<Ring>::from(plane.normal));
}
FlatEquation equation_of(const ParametricPlane& plane) {
  return plane_through(plane.point, cross(Vector<Ring>::from(plane.u), Vector<Ring>::from(plane.v)));
}

template <class Plane>
class PlaneIntersection final : public FlatIntersection {
 public:
  PlaneIntersection(const RayQuestion& question, const Plane& plane)
      : FlatIntersection(question, equation_of(plane)), plane_(plane) {}

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
  [[nodiscard]] Scaled position() const override {
    if constexpr (requires { plane_.point; })
      return norm(plane_.point);
    else
      return abs(Scaled(plane_.d)) / norm(plane_.normal);
  }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    if constexpr (requires { plane_.normal; })
      return {norm(plane_.normal)};
    else
      return {norm(plane_.u) * norm(plane_.v)};
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

}  // namespace rayproof::oracle
