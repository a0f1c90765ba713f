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
