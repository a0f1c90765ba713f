/// \file
/// Polygons, computed independently: CGAL's bounded_side_2 where the outline is simple, and for all others
/// the parity of the triangles that the sides span with an apex, which casts no ray and passes no vertex.

#include <CGAL/Polygon_2_algorithms.h>

#include "unit/oracle/independent/meeting.hpp"

namespace rayproof::oracle::test {
namespace {

using Point2 = Kernel::Point_2;
using ExactOutline = std::vector<Point2>;

bool is_on_side(const Point2& p, const Point2& a, const Point2& b) {
  return a == b ? p == a : Kernel::Segment_2(a, b).has_on(p);
}

/// Whether p, which lies on no line through the apex and a vertex, is in an odd number of the triangles of
/// the apex and a side.
bool is_in_odd_number(const Point2& p, const Point2& apex, const ExactOutline& vertices) {
  bool odd = false;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point2 &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
    const auto turn = CGAL::orientation(a, b, p);
    if (turn != CGAL::COLLINEAR && turn == CGAL::orientation(b, apex, p) &&
        turn == CGAL::orientation(apex, a, p))
      odd = !odd;
  }
  return odd;
}

/// An apex from which p is seen in line with no vertex: of the points of a parabola, which no line meets more
/// than twice, one of the first few will do.
Point2 clear_apex(const Point2& p, const ExactOutline& vertices) {
  for (int k = 1;; ++k) {
    const Point2 apex(p.x() + k, p.y() + 7 * k * k + 1);
    const bool is_clear = std::none_of(vertices.begin(), vertices.end(),
                                       [&](const Point2& v) { return CGAL::collinear(apex, v, p); });
    if (is_clear) return apex;
  }
}

/// The contact of a point with the closed polygon, `none` outside.
Contact contact_with(const Point2& p, const ExactOutline& vertices) {
  if (std::find(vertices.begin(), vertices.end(), p) != vertices.end()) return Contact::vertex;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (is_on_side(p, vertices[i], vertices[(i + 1) % vertices.size()])) return Contact::edge;
  const bool inside = is_in_odd_number(p, clear_apex(p, vertices), vertices);
  if (CGAL::is_simple_2(vertices.begin(), vertices.end(), Kernel())) {
    const auto side = CGAL::bounded_side_2(vertices.begin(), vertices.end(), p, Kernel());
    EXPECT_EQ(inside, side == CGAL::ON_BOUNDED_SIDE);
  }
  return inside ? Contact::crossing : Contact::none;
}

/// Twice the vector area, summed in triangles about the first vertex.
Vector3 area_of(const std::vector<Point>& vertices) {
  Vector3 area(0, 0, 0);
  for (std::size_t i = 2; i < vertices.size(); ++i)
    area = area + CGAL::cross_product(vertices[i - 1] - vertices[0], vertices[i] - vertices[0]);
  return area;
}

/// The axis to drop, the later one of a tie.
int dropped_axis(const Vector3& normal) {
  int largest = 2;
  for (const int axis : {1, 0})
    if (abs(normal[axis]) > abs(normal[largest])) largest = axis;
  return largest;
}

RationalMeeting meet(const RationalRay& ray, const Ray<double>& interval, const Polygon<double>& polygon) {
  std::vector<Point> vertices;
  for (const glm::dvec3& v : polygon.vertices) vertices.push_back(point_of(v));
  const Vector3 normal = area_of(vertices);
  if (normal == CGAL::NULL_VECTOR) return {.contact = Contact::degenerate};
  const Rational slope = normal * ray.direction;
  const Rational gap = normal * (vertices[0] - ray.origin);
  if (slope == 0) return {.contact = gap == 0 ? Contact::in_surface : Contact::parallel};
  const Rational t = gap / slope;
  const int axis = dropped_axis(normal);
  const auto flat = [&](const Point& p) { return Point2(p[axis == 0 ? 1 : 0], p[axis == 2 ? 1 : 2]); };
  ExactOutline outline;
  for (const Point& v : vertices) outline.push_back(flat(v));
  const Contact contact = contact_with(flat(ray.origin + t * ray.direction), outline);
  if (contact == Contact::none || !is_within(t, interval)) return {};
  return {contact, {t}, normal};
}

TEST(IndependentComputation, TrianglesAboutAnApexAgreeWithPolygons) {
  for_each_case("polygon", independent_cases / 2, [](Case one) {
    const RayQuestion& asked = question_of(one);
    const RationalRay ray(asked);
    expect_agrees(one, ray, meet(ray, asked.ray, std::get<Polygon<double>>(asked.shape)));
  });
}

TEST(IndependentComputation, TrianglesAboutAnApexAgreeWithPointInPolygon) {
  for_each_case("point_in_polygon", independent_cases, [](const Case& one) {
    const auto& asked = std::get<PointAndPolygon<double>>(one.question);
    const auto point = [](const Vec2<double>& v) { return Point2(Rational(v.x), Rational(v.y)); };
    ExactOutline outline;
    for (const Vec2<double>& v : asked.vertices) outline.push_back(point(v));
    const Contact contact = contact_with(point(asked.point), outline);
    const Position expected = contact == Contact::none       ? Position::outside
                              : contact == Contact::crossing ? Position::inside
                                                             : Position::boundary;
    EXPECT_EQ(std::get<Position>(answer(one)), expected);
  });
}

// A polygon of three vertices is a triangle; the two know nothing of each other in the oracle.
TEST(IndependentComputation, TrianglesAgreeWithPolygonsOfThreeVertices) {
  for_each_case("triangle", independent_cases, [](Case one) {
    const RayAnswer as_triangle = ray_answer(one);
    RayQuestion& asked = question_of(one);
    const auto triangle = std::get<Triangle<double>>(asked.shape);
    asked.shape = Polygon<double>{{triangle.a, triangle.b, triangle.c}};
    const RayAnswer as_polygon = ray_answer(one);
    EXPECT_TRUE(std::ranges::equal(as_triangle.hits.view(), as_polygon.hits.view()));
    EXPECT_EQ(as_triangle.contact, as_polygon.contact);
    EXPECT_EQ(as_triangle.point, as_polygon.point);
    EXPECT_EQ(as_triangle.normal, as_polygon.normal);
  });
}

}  // namespace
}  // namespace rayproof::oracle::test
