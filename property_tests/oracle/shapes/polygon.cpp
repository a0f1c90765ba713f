#include "oracle/shapes/polygon.hpp"

#include "oracle/geometry/newell.hpp"
#include "oracle/geometry/polygon_plane.hpp"
#include "oracle/geometry/triangle_volumes.hpp"

namespace rayproof::oracle {
namespace {

/// |x|, exactly.
Ring magnitude(const Ring& x) { return sign(x) < 0 ? -x : x; }

Position position_of(Place place) {
  if (place == Place::inside) return Position::inside;
  return place == Place::outside ? Position::outside : Position::boundary;
}

/// The place in the polygon's projection of the point in which the line meets the plane at t.
Place place_of(const ObjectRay<Ring>& ray, const Polygon<double>& polygon, const Vector<Ring>& normal,
               const Quotient& t) {
  const Projection projection(normal);
  // In the scale of ObjectRay, and times the denominator of t.
  Vector<Ring> point = t.denominator() * ray.origin + t.numerator() * ray.direction;
  Ring weight = ray.scale * t.denominator();
  if (sign(weight) < 0) {
    point = Ring(-1.0) * point;
    weight = -weight;
  }
  return locate(projection(point), weight, projected(polygon, projection));
}

}  // namespace

FlatEquation plane_of(const Polygon<double>& polygon) {
  const auto normal = newell_normal<Ring>(polygon);
  return {normal, dot(normal, Vector<Ring>::from(polygon.vertices.front()))};
}

Projection::Projection(const Vector<Ring>& normal) {
  const std::array<Ring, 3> sizes{magnitude(normal.x), magnitude(normal.y), magnitude(normal.z)};
  std::size_t largest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (sign(sizes[axis] - sizes[largest]) >= 0) largest = axis;
  }
  x = largest == 0 ? 1 : 0;
  y = largest == 2 ? 1 : 2;
}

std::vector<PlanePoint> projected(const Polygon<double>& polygon, const Projection& projection) {
  std::vector<PlanePoint> points;
  points.reserve(polygon.vertices.size());
  for (const glm::dvec3& vertex : polygon.vertices)
    points.push_back({Ring(vertex[projection.x]), Ring(vertex[projection.y])});
  return points;
}

RayAnswer answer(const RayQuestion& question, const Polygon<double>& polygon, Precision precision) {
  const FlatEquation plane = plane_of(polygon);
  RayAnswer miss;
  if (is_zero(plane.normal)) {
    miss.contact = Contact::degenerate;
    return miss;
  }
  const ObjectRay<Ring> ray(question);
  const FlatMeeting meeting(ray, plane);
  if (meeting.is_parallel()) {
    miss.contact = meeting.parallel_contact();
    return miss;
  }
  const Quotient t = meeting.t();
  if (!is_in_interval(t, question.ray)) return miss;
  const Place place = place_of(ray, polygon, plane.normal, t);
  if (place == Place::outside) return miss;
  const Contact contact = place == Place::vertex ? Contact::vertex
                          : place == Place::side ? Contact::edge
                                                 : Contact::crossing;
  return flat_answer(question, ray, plane.normal, t, contact, precision);
}

Position answer(const PointAndPolygon<double>& question) {
  std::vector<PlanePoint> vertices;
  vertices.reserve(question.vertices.size());
  for (const auto& vertex : question.vertices) vertices.push_back({Ring(vertex.x), Ring(vertex.y)});
  return position_of(locate({Ring(question.point.x), Ring(question.point.y)}, Ring(1.0), vertices));
}

}  // namespace rayproof::oracle
