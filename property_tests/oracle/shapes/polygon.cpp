/// \file
/// The oracle for ray and polygon.

#include <algorithm>

#include "oracle/geometry/clearance.hpp"
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

  /// How near the ray comes to a side, or one of its ends to the polygon.
  [[nodiscard]] Scaled margin(bool) const override {
    const Scaled scale = approximate(ray().scale);
    const RayPart part{approximate(ray().direction), question().ray.t_min, question().ray.t_max,
                       scale * sizes().origin, scale * sizes().direction};
    const auto seen = [&](const glm::dvec3& vertex) {
      return approximate(ray().scale * Vector<Ring>::from(vertex) - ray().origin);
    };
    Scaled nearest = endless();
    Vector<Scaled> from = seen(polygon_.vertices.back());
    for (const glm::dvec3& vertex : polygon_.vertices) {
      const Vector<Scaled> to = seen(vertex);
      reduce(nearest, part.distance_to(from, to));
      from = to;
    }
    for (const double end : finite_ends(question().ray)) reduce(nearest, height_over_polygon(end));
    return nearest;
  }

 protected:
  [[nodiscard]] Contact contact_at(const Quotient& t) const override {
    return located(t.denominator() * ray().origin + t.numerator() * ray().direction, t.denominator());
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
  /// As large as seen from any of its vertices.
  [[nodiscard]] Scaled size_of_products() const override {
    const auto first = Vector<Ring>::from(polygon_.vertices.front());
    Scaled reach;
    for (const glm::dvec3& vertex : polygon_.vertices)
      reach = std::max(reach, norm(Vector<Ring>::from(vertex) - first));
    return Scaled(static_cast<double>(polygon_.vertices.size())) * reach * reach;
  }

 private:
  /// How a point of the plane touches the polygon; the point comes times a positive weight.
  [[nodiscard]] Contact located(const Vector<Ring>& point, const Ring& weight) const {
    const Projection project(plane_normal());
    std::vector<PlanePoint> vertices;
    vertices.reserve(polygon_.vertices.size());
    for (const glm::dvec3& vertex : polygon_.vertices) vertices.push_back(project(vertex));
    return locate(project(point), ray().scale * weight, vertices);
  }

  /// The distance of p(t) from the polygon in units of L(t), where its foot on the plane lies in it; endless
  /// beside it, where its sides are nearest, and where it has no area.
  [[nodiscard]] Scaled height_over_polygon(double t) const {
    const Vector<Ring>& normal = plane_normal();
    const Ring squared = dot(normal, normal), height = height_at(t);
    if (sign(squared) == 0) return endless();
    const Vector<Ring> foot = squared * (ray().origin + Ring(t) * ray().direction) - height * normal;
    if (located(foot, squared) == Contact::none) return endless();
    const Scaled reach = approximate(ray().scale) * sizes().reach(Scaled(t));
    return ratio(abs(approximate(height)), sqrt(approximate(squared)) * reach);
  }

  const Polygon<double>& polygon_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Polygon<double>& polygon) {
  return std::make_unique<PolygonIntersection>(question, polygon);
}

}  // namespace rayproof::oracle
