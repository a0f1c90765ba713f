#pragma once
/// \file
/// What the independent computation says of a question with a rational t, and how the oracle's answer is held
/// against it.

#include <algorithm>

#include "unit/oracle/every_case.hpp"
#include "unit/oracle/independent/rational.hpp"

namespace rayproof::oracle::test {

/// The exact answer before rounding.
struct RationalMeeting {
  Contact contact = Contact::none;
  std::vector<Rational> hits{};     ///< those in the interval, ascending
  std::optional<Vector3> normal{};  ///< of the shape in its own space, of any length
  std::optional<Vector3> barycentric{};
};

/// A normal in the world, by the inverse transpose: the cofactors of the map, and the sign of its volume.
[[nodiscard]] inline Vector3 to_world(const RationalRay& ray, const Vector3& normal) {
  if (!ray.to_world) return normal;
  const auto inverse = ray.to_world->inverse();
  const auto row = [&](int j) {
    return inverse.m(0, j) * normal.x() + inverse.m(1, j) * normal.y() + inverse.m(2, j) * normal.z();
  };
  return {row(0), row(1), row(2)};
}

/// Whether each component is within an ulp of 1 (and a little, for the rounding here) of the unit vector.
inline void expect_unit(const glm::dvec3& found, const Vector3& exact, Precision precision) {
  const Rational largest = std::max({abs(exact.x()), abs(exact.y()), abs(exact.z())});
  const glm::dvec3 direction(Rational(exact.x() / largest).to_double(),
                             Rational(exact.y() / largest).to_double(),
                             Rational(exact.z() / largest).to_double());
  const glm::dvec3 unit = direction / glm::length(direction);
  const double tolerance = precision == Precision::float32 ? 0x1p-23 : 0x1p-51;
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], unit[axis], tolerance);
}

/// Whether the oracle's answer is the meeting, every number of it rounded once.
inline void expect_agrees(const Case& one, const RationalRay& ray, const RationalMeeting& meeting) {
  const RayAnswer found = ray_answer(one);
  EXPECT_EQ(found.contact, meeting.contact);
  ASSERT_EQ(found.hits.count, meeting.hits.size());
  for (std::size_t i = 0; i < meeting.hits.size(); ++i)
    EXPECT_TRUE(is_nearest(found.hits.t[i], meeting.hits[i], one.precision)) << found.hits.t[i];
  ASSERT_EQ(found.point.has_value(), !meeting.hits.empty());
  ASSERT_EQ(found.normal.has_value(), meeting.normal.has_value());
  ASSERT_EQ(found.barycentric.has_value(), meeting.barycentric.has_value());
  for (int axis = 0; axis < 3; ++axis) {
    if (found.point) {
      const Rational exact = ray.world_origin[axis] + meeting.hits[0] * ray.world_direction[axis];
      EXPECT_TRUE(is_nearest((*found.point)[axis], exact, one.precision)) << (*found.point)[axis];
    }
    if (found.barycentric) {
      const Rational& exact = (*meeting.barycentric)[axis];
      EXPECT_TRUE(is_nearest((*found.barycentric)[axis], exact, one.precision)) << (*found.barycentric)[axis];
    }
  }
  if (found.normal) expect_unit(*found.normal, to_world(ray, *meeting.normal), one.precision);
}

/// How many cases of each family the independent computation is tried on; ten times as many of whole numbers.
inline constexpr std::uint64_t independent_cases = 60;

}  // namespace rayproof::oracle::test
