/// \file
/// Planes and triangles, computed independently: CGAL's intersections of a line with Plane_3 and Triangle_3
/// over rational numbers.

#include <CGAL/intersections.h>

#include "unit/oracle/independent/meeting.hpp"

namespace rayproof::oracle::test {
namespace {

using Plane3 = Kernel::Plane_3;

Plane3 plane_of(const ImplicitPlane& plane) {
  return {Rational(plane.normal.x), Rational(plane.normal.y), Rational(plane.normal.z), Rational(plane.d)};
}
Plane3 plane_of(const PointNormalPlane& plane) { return {point_of(plane.point), vector_of(plane.normal)}; }
Plane3 plane_of(const ParametricPlane& plane) {
  const Point at = point_of(plane.point);
  return {at, at + vector_of(plane.u), at + vector_of(plane.v)};
}

/// Why a line that meets the plane in no single point has no hit.
Contact parallel_contact(const Kernel::Line_3& line, const Plane3& plane) {
  return plane.has_on(line) ? Contact::in_surface : Contact::parallel;
}

template <class S>
RationalMeeting meet(const RationalRay& ray, const Ray<double>& interval, const S& shape) {
  const Plane3 plane = plane_of(shape);
  const auto meeting = CGAL::intersection(ray.line(), plane);
  const Point* point = meeting ? boost::get<Point>(&*meeting) : nullptr;
  if (point == nullptr) return {.contact = parallel_contact(ray.line(), plane)};
  const Rational t = ray.t_of(*point);
  if (!is_within(t, interval)) return {};
  return {Contact::crossing, {t}, plane.orthogonal_vector()};
}

Contact contact_at(const Kernel::Triangle_3& triangle, const Point& point) {
  for (int i = 0; i < 3; ++i)
    if (triangle[i] == point) return Contact::vertex;
  for (int i = 0; i < 3; ++i)
    if (Kernel::Segment_3(triangle[i], triangle[i + 1]).has_on(point)) return Contact::edge;
  return Contact::crossing;
}

/// The coordinates by areas in the triangle's plane, over the square of the normal.
Vector3 barycentric(const Kernel::Triangle_3& triangle, const Point& q, const Vector3& normal) {
  const auto share = [&](int i) -> Rational {
    return CGAL::cross_product(triangle[i + 1] - q, triangle[i + 2] - q) * normal / normal.squared_length();
  };
  return {share(0), share(1), share(2)};
}

RationalMeeting meet(const RationalRay& ray, const Ray<double>& interval, const Triangle<double>& shape) {
  const Kernel::Triangle_3 triangle(point_of(shape.a), point_of(shape.b), point_of(shape.c));
  if (triangle.is_degenerate()) return {.contact = Contact::degenerate};
  const Plane3 plane = triangle.supporting_plane();
  const Rational slope = plane.orthogonal_vector() * ray.direction;
  if (slope == 0) return {.contact = parallel_contact(ray.line(), plane)};
  const auto meeting = CGAL::intersection(ray.line(), triangle);
  if (!meeting) return {};
  const Point point = boost::get<Point>(*meeting);
  const Rational t = ray.t_of(point);
  if (!is_within(t, interval)) return {};
  const Vector3 normal = CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  return {contact_at(triangle, point), {t}, normal, barycentric(triangle, point, normal)};
}

TEST(IndependentComputation, CgalsPlanesAgree) {
  for_each_case("plane", independent_cases, [](Case one) {
    const RayQuestion& asked = question_of(one);
    const RationalRay ray(asked);
    if (const auto* implicit = std::get_if<ImplicitPlane>(&asked.shape))
      expect_agrees(one, ray, meet(ray, asked.ray, *implicit));
    if (const auto* upright = std::get_if<PointNormalPlane>(&asked.shape))
      expect_agrees(one, ray, meet(ray, asked.ray, *upright));
    if (const auto* spanned = std::get_if<ParametricPlane>(&asked.shape))
      expect_agrees(one, ray, meet(ray, asked.ray, *spanned));
  });
}

TEST(IndependentComputation, CgalsTrianglesAgree) {
  for_each_case("triangle", independent_cases, [](Case one) {
    const RayQuestion& asked = question_of(one);
    const RationalRay ray(asked);
    expect_agrees(one, ray, meet(ray, asked.ray, std::get<Triangle<double>>(asked.shape)));
  });
}

}  // namespace
}  // namespace rayproof::oracle::test
