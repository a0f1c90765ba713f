/// \file
/// The cylinder's normal, computed independently: the gradient of its equation at the point of the answer,
/// which is within half an ulp of the exact one in every coordinate.

#include "unit/oracle/every_case.hpp"

namespace rayproof::oracle::test {
namespace {

using Extended = long double;  // no square of a double leaves its range

/// The unit vector along (x/rx², y/ry², 0).
glm::dvec3 side_normal(const Cylinder<double>& tube, const glm::dvec3& point) {
  const Extended rx = tube.rx, ry = tube.ry;
  const Extended x = Extended{point.x} / rx / rx, y = Extended{point.y} / ry / ry;
  const Extended length = std::hypot(x, y);
  return {static_cast<double>(x / length), static_cast<double>(y / length), 0};
}

/// Whether the point is on the side rather than within a cap.
bool is_on_side(const Cylinder<double>& tube, const glm::dvec3& point) {
  const Extended x = Extended{point.x} / tube.rx, y = Extended{point.y} / tube.ry;
  return x * x + y * y > 1 - 0x1p-15L;
}

TEST(IndependentComputation, GradientsAgreeWithTheNormalsOfCylinders) {
  std::size_t tried = 0;
  for_each_case("cylinder", 100, [&](Case one) {
    const RayAnswer found = ray_answer(one);
    if (!found.normal || question_of(one).transform) return;
    const auto& tube = std::get<Cylinder<double>>(question_of(one).shape);
    const glm::dvec3& point = *found.point;
    const bool narrow = one.precision == Precision::float32;
    const double least = narrow ? 0x1p-120 : 0x1p-1000;  // below, a rounded coordinate has few digits left
    if (std::abs(point.x) < least || std::abs(point.y) < least) return;
    ++tried;
    const double tolerance = narrow ? 0x1p-21 : 0x1p-50;
    const bool on_cap = found.normal->z != 0;
    if (on_cap) {
      const double outward = point.z == tube.height ? 1 : -1;
      EXPECT_TRUE(outward > 0 || point.z == 0);
      EXPECT_EQ(*found.normal, glm::dvec3(0, 0, outward));
      return;
    }
    ASSERT_TRUE(is_on_side(tube, point));
    const glm::dvec3 expected = side_normal(tube, point);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR((*found.normal)[axis], expected[axis], tolerance);
  });
  EXPECT_GT(tried, 500U);
}

}  // namespace
}  // namespace rayproof::oracle::test
