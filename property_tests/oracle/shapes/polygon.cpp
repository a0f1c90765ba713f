/// \file
/// The oracle for ray and polygon.

#include <algorithm>

#include "oracle/geometry/locate.hpp"
#include "oracle/geometry/newell.hpp"
#include "oracle/shapes/flat.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// The coordinates that are left where the axis of the normal's largest component is dropped (ties: the later
/// axis).
struct Projection {
  int x = 0, y = 1;

  explicit Projection(const Vector<Ring>& normal) {
    const auto magnitude = [&](int axis) { return sign(normal[axis]) < 0 ? -normal[axis] : normal[axis]; };
    int largest = 0;
    for (const int axis : {1, 2})
      if (sign(magnitude(axis) - magnitude(largest)) >= 0) largest = axis;
    x = largest == 0 ? 1 : 0;
    y = largest == 2 ? 1 : 2;
  }

  [[nodiscard]] PlanePoint operator()(const Vector<Ring>& v) const { return {v[x], v[y]}; }
  [[nodiscard]] PlanePoint operator()(const glm::dvec3& v) const { return {Ring(v[x]), Ring(v[y])}; }
};

class PolygonIntersection final : public FlatIntersection {
 public:
  PolygonIntersection(const RayQuestion& question, const Polygon<double>& polygon)
      : FlatIntersection(question, plane_through(polygon.vertices.front(), newell_normal<Ring>(polygon))),
        polygon_(polygon) {}

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = FlatIntersection::margin();
    reduce(nearest, steepness());
    if (is_parallel()) return nearest;
    const Scaled unit = sizes().reach(t().estimate()) / steepness();
    const PlaneMeeting at = meeting(t());
    const PlanePoint* from = &at.vertices.back();
    for (const PlanePoint& to : at.vertices) {
      reduce(nearest, ratio(distance_to_side(at.point, at.weight, *from, to), unit));
      from = &to;
    }
    return nearest;
  }

 protected:
  [[nodiscard]] Contact contact_at(const Quotient& t) const override {
    const PlaneMeeting at = meeting(t);
    return locate(at.point, at.weight, at.vertices);
  }

  [[nodiscard]] Scaled position() const override {
    Scaled farthest;
    for (const glm::dvec3& vertex : polygon_.vertices) farthest = std::max(farthest, norm(vertex));
    return farthest;
  }
  /// The sum of the products that Newell's normal is made of.
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    Scaled sum;
    const glm::dvec3* from = &polygon_.vertices.back();
    for (const glm::dvec3& to : polygon_.vertices) {
      sum = sum + norm(*from) * norm(to);
      from = &to;
    }
    return {sum};
  }

 private:
  /// The point in which the line meets the plane, times a positive weight, and the vertices, projected.
  struct PlaneMeeting {
    PlanePoint point;
    Ring weight;
    std::vector<PlanePoint> vertices;
  };
  [[nodiscard]] PlaneMeeting meeting(const Quotient& t) const {
    const Projection project(plane_normal());
    const Vector<Ring> point = t.denominator() * ray().origin + t.numerator() * ray().direction;
    PlaneMeeting at{project(point), ray().scale * t.denominator(), {}};
    at.vertices.reserve(polygon_.vertices.size());
    for (const glm::dvec3& vertex : polygon_.vertices) at.vertices.push_back(project(vertex));
    return at;
  }

  const Polygon<double>& polygon_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Polygon<double>& polygon) {
  return std::make_unique<PolygonIntersection>(question, polygon);
}

}  // namespace rayproof::oracle
