/// \file
/// Boxes and parallelepipeds, computed independently: CGAL's intersection of a line with Iso_cuboid_3 over
/// rational numbers; a parallelepiped is the unit cube under the map that its edges are.

#include <CGAL/intersections.h>

#include "unit/oracle/independent/meeting.hpp"

namespace rayproof::oracle::test {
namespace {

/// The outward normal of the one face that holds p; none where there are several.
std::optional<Vector3> face_normal(const Kernel::Iso_cuboid_3& cuboid, const Point& p) {
  std::vector<Vector3> normals;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [&](int sign) {
      return Vector3(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
    };
    if (p[axis] == (cuboid.min)()[axis]) normals.push_back(along(-1));
    if (p[axis] == (cuboid.max)()[axis]) normals.push_back(along(1));
  }
  if (normals.size() != 1) return std::nullopt;
  return normals[0];
}

RationalMeeting meet(const RationalRay& ray, const Ray<double>& interval,
                     const Kernel::Iso_cuboid_3& cuboid) {
  const auto meeting = CGAL::intersection(ray.line(), cuboid);
  if (!meeting) return {};
  std::vector<Rational> ends;
  if (const Point* point = boost::get<Point>(&*meeting)) {
    ends = {ray.t_of(*point)};
  } else {
    const auto& chord = boost::get<Kernel::Segment_3>(*meeting);
    ends = {ray.t_of(chord.source()), ray.t_of(chord.target())};
    std::sort(ends.begin(), ends.end());
  }
  RationalMeeting result{.contact = ends.size() == 1 ? Contact::tangent : Contact::crossing};
  for (const Rational& t : ends)
    if (is_within(t, interval)) result.hits.push_back(t);
  if (result.hits.empty()) return {};
  result.normal = face_normal(cuboid, ray.origin + result.hits[0] * ray.direction);
  return result;
}

TEST(IndependentComputation, CgalsIsoCuboidsAgree) {
  for_each_case("box", independent_cases, [](Case one) {
    const RayQuestion& asked = question_of(one);
    const RationalRay ray(asked);
    const auto& box = std::get<Box<double>>(asked.shape);
    expect_agrees(one, ray, meet(ray, asked.ray, {point_of(box.min), point_of(box.max)}));
  });
}

TEST(IndependentComputation, UnitCubesUnderAMapAgreeWithParallelepipeds) {
  for_each_case("parallelepiped", independent_cases, [](Case one) {
    const RayQuestion& asked = question_of(one);
    const auto& solid = std::get<Parallelepiped<double>>(asked.shape);
    const auto& [u, v, w] = solid.edges;
    const glm::dmat4 edges(glm::dvec4(u, 0), glm::dvec4(v, 0), glm::dvec4(w, 0), glm::dvec4(solid.corner, 1));
    RationalRay ray(asked);
    const auto to_cube = map_of(edges).inverse();
    ray.origin = to_cube.transform(ray.origin);
    ray.direction = to_cube.transform(ray.direction);
    ray.to_world = ray.to_world ? *ray.to_world * map_of(edges) : map_of(edges);
    expect_agrees(one, ray, meet(ray, asked.ray, {Point(0, 0, 0), Point(1, 1, 1)}));
  });
}

// The same cases in the other's words: a box with thickness is a parallelepiped of three edges along the
// axes.
TEST(IndependentComputation, BoxesAgreeWithTheParallelepipedsThatTheyAre) {
  std::size_t tried = 0;
  for_each_case("box", independent_cases, [&](Case one) {
    const RayAnswer as_box = ray_answer(one);
    RayQuestion& asked = question_of(one);
    const auto box = std::get<Box<double>>(asked.shape);
    const glm::dvec3 size = box.max - box.min;
    for (int axis = 0; axis < 3; ++axis) {  // only where the difference is exact, and not 0
      if (!(size[axis] > 0) || Rational(box.max[axis]) - Rational(box.min[axis]) != Rational(size[axis]))
        return;
    }
    ++tried;
    asked.shape = Parallelepiped<double>{
        box.min, {glm::dvec3(size.x, 0, 0), glm::dvec3(0, size.y, 0), glm::dvec3(0, 0, size.z)}};
    const RayAnswer as_solid = ray_answer(one);
    EXPECT_TRUE(std::ranges::equal(as_box.hits.view(), as_solid.hits.view()));
    EXPECT_EQ(as_box.contact, as_solid.contact);
    EXPECT_EQ(as_box.point, as_solid.point);
    EXPECT_EQ(as_box.normal.has_value(), as_solid.normal.has_value());
  });
  EXPECT_GT(tried, 1000U);
}

}  // namespace
}  // namespace rayproof::oracle::test
