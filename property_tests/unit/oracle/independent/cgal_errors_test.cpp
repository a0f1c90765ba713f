/// \file
/// What CGAL 5.5.1 is known to answer wrongly, over exact rational numbers too, and the oracle's answers to
/// the same questions. That CGAL is wrong is claimed of that version alone.

#include <CGAL/Bbox_3.h>
#include <CGAL/intersections.h>
#include <CGAL/version.h>

#include "generators/random.hpp"
#include "unit/oracle/independent/rational.hpp"

namespace rayproof::oracle::test {
namespace {

constexpr bool is_known_version = CGAL_VERSION_NR == 1050511000;

/// Two points of the plane z = 0 for a line, and two for a ray.
struct LineAndRay {
  glm::dvec3 a, b, source, through;

  [[nodiscard]] bool cgal_says() const {
    return CGAL::do_intersect(Kernel::Line_3(point_of(a), point_of(b)),
                              Kernel::Ray_3(point_of(source), point_of(through)));
  }
  [[nodiscard]] Ray<double> ray() const { return {source, through - source}; }
  /// The upright plane through the line: a ray in z = 0 meets it just where it meets the line.
  [[nodiscard]] ParametricPlane wall() const { return {a, b - a, {0, 0, 1}}; }
};

// Found by search among points of -2 … 2. The line is the axis of x, which the ray passes at (-1/2, 0, 0).
TEST(CgalsErrors, ARayThatMeetsALineIsTakenForAMiss) {
  const LineAndRay one{{-1, 0, 0}, {-2, 0, 0}, {-1, -1, 0}, {0, 1, 0}};
  if (is_known_version) {
    EXPECT_FALSE(one.cgal_says());
  }
  const RayAnswer found = met(one.ray(), one.wall());
  expect_hits(found, Contact::crossing, {0.5});
  EXPECT_EQ(*found.point, glm::dvec3(-0.5, 0, 0));
  // A triangle that stands on the line is met on that edge.
  expect_hits(met(one.ray(), Triangle<double>{{-2, 0, 0}, {2, 0, 0}, {0, 0, 1}}), Contact::edge, {0.5});
}

// Found by the same search. The line is y = 1; the ray begins at y = -1 and goes down.
TEST(CgalsErrors, ARayThatLeavesALineIsTakenForAHit) {
  const LineAndRay one{{-2, 1, 0}, {2, 1, 0}, {-2, -1, 0}, {1, -2, 0}};
  if (is_known_version) {
    EXPECT_TRUE(one.cgal_says());
  }
  expect_miss(met(one.ray(), one.wall()), Contact::none);
  Ray<double> line = one.ray();
  line.t_min = -infinity<double>;
  expect_hits(met(line, one.wall()), Contact::crossing, {-2});
}

// The search itself: the truth is the sign of one quotient of whole numbers.
TEST(CgalsErrors, TheOracleIsRightWhereverLinesAndRaysGoWrong) {
  Random random(0);
  const auto place = [&] {
    const double x = random.between(-2, 2);
    return glm::dvec3(x, random.between(-2, 2), 0);
  };
  int wrong = 0, tried = 0;
  for (int i = 0; i < 5000; ++i) {
    const LineAndRay one{place(), place(), place(), place()};
    if (one.a == one.b || one.source == one.through) continue;
    const glm::dvec3 along = one.b - one.a, d = one.through - one.source, to = one.a - one.source;
    const double slope = d.x * along.y - d.y * along.x, gap = to.x * along.y - to.y * along.x;
    if (slope == 0) continue;
    const bool meets = gap * slope >= 0;
    ++tried;
    if (one.cgal_says() != meets) ++wrong;
    EXPECT_EQ(met(one.ray(), one.wall()).hits.count, meets ? 1U : 0U);
  }
  EXPECT_GT(tried, 3000);
  if (is_known_version) {
    EXPECT_GT(wrong, 300);
  }
}

// The intersection with a Bbox_3 is computed in double, whatever the kernel. With n = 2^28 the ray comes into
// the box's x at t = n/(n+1) and has left its y at (n-1)/n, earlier by about 2^-56: one double for both.
TEST(CgalsErrors, ARayThatMissesABboxByRoundingIsTakenForATouch) {
  const double n = 0x1p+28;
  const Box<double> box{{n, 0, -1}, {2 * n, n - 1, 1}};
  const glm::dvec3 direction(n + 1, n, 0);
  const Kernel::Ray_3 ray(point_of(glm::dvec3(0)), vector_of(direction));
  if (is_known_version) {
    EXPECT_TRUE(CGAL::intersection(CGAL::Bbox_3(n, 0, -1, 2 * n, n - 1, 1), ray));
  }
  EXPECT_FALSE(CGAL::intersection(Kernel::Iso_cuboid_3(point_of(box.min), point_of(box.max)), ray));
  expect_miss(met({{0, 0, 0}, direction}, box), Contact::none);
  // A step less in x, and both are at t = (n-1)/n: there the ray does touch the edge.
  expect_hits(met({{0, 0, 0}, {n, n, 0}}, Box<double>{{n - 1, 0, -1}, {2 * n, n - 1, 1}}), Contact::tangent,
              {1 - 0x1p-28});
}

// A third is not a double, and so the ray's entry at t = 1/3,
// where y = 0, comes out beside the box.
TEST(CgalsErrors, TheChordInABboxIsNotInIt) {
  const Kernel::Ray_3 ray(Point(0, -1, 0), Vector3(1, 3, 0));
  const auto inside = CGAL::intersection(CGAL::Bbox_3(0, 0, -1, 4, 2, 1), ray);
  ASSERT_TRUE(inside);
  const Point entry = boost::get<Kernel::Segment_3>(*inside).source();
  if (is_known_version) {
    EXPECT_NE(entry.y(), 0);
  }
  const RayAnswer found = met({{0, -1, 0}, {1, 3, 0}}, Box<double>{{0, 0, -1}, {4, 2, 1}});
  expect_hits(found, Contact::crossing, {1.0 / 3, 1});
  EXPECT_EQ(*found.point, glm::dvec3(1.0 / 3, 0, 0));
  EXPECT_EQ(*found.normal, glm::dvec3(0, -1, 0));
}

}  // namespace
}  // namespace rayproof::oracle::test
