/// \file
/// The oracle judged by itself: scenes moved, mirrored, turned and scaled without a rounding, in which every
/// shape must be met at the same t, in the same way, at the moved point.

#include "unit/oracle/every_case.hpp"
#include "unit/oracle/motions.hpp"

namespace rayproof::oracle::test {
namespace {

using OracleMotion = EveryShape;
INSTANTIATE_TEST_SUITE_P(Of, OracleMotion, testing::ValuesIn(ray_topics()), topic_name);

/// The cylinder's axis is fixed; its own motions are in step_test.cpp.
using OracleMotionOfFields = EveryShape;
std::vector<std::string> topics_that_move() {
  std::vector<std::string> topics = ray_topics();
  std::erase(topics, "cylinder");
  return topics;
}
INSTANTIATE_TEST_SUITE_P(Of, OracleMotionOfFields, testing::ValuesIn(topics_that_move()), topic_name);

constexpr std::uint64_t cases_a_motion = 60;

void expect_same_meeting(const RayAnswer& before, const RayAnswer& after) {
  EXPECT_TRUE(std::ranges::equal(before.hits.view(), after.hits.view()));
  EXPECT_EQ(before.contact, after.contact);
  EXPECT_EQ(before.barycentric, after.barycentric);
  EXPECT_EQ(before.point.has_value(), after.point.has_value());
  EXPECT_EQ(before.normal.has_value(), after.normal.has_value());
}

/// Normals are within an ulp of 1, and not always rounded alike.
void expect_near(const glm::dvec3& expected, const glm::dvec3& found, Precision precision) {
  const double tolerance = precision == Precision::float32 ? 0x1p-22 : 0x1p-51;
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(expected[axis], found[axis], tolerance);
}

void expect_moved(const Case& one, const RayQuestion& moved_question, const Motion& motion, double hand) {
  const RayAnswer before = ray_answer(one);
  const RayAnswer after = ray_answer({.precision = one.precision, .question = moved_question});
  expect_same_meeting(before, after);
  if (before.point && after.point) {
    EXPECT_EQ(motion(*before.point), *after.point);
  }
  if (before.normal && after.normal) expect_near(hand * motion(*before.normal), *after.normal, one.precision);
}

/// Whether the shape's normal comes from a vector product of its fields, and turns round with the hand.
bool has_handed_normal(const Shape& shape) {
  return std::holds_alternative<ParametricPlane>(shape) || std::holds_alternative<Triangle<double>>(shape) ||
         std::holds_alternative<Polygon<double>>(shape);
}

TEST_P(OracleMotion, ExchangingAndMirroringAxesByTheTransformMovesNothingElse) {
  for_each_case(GetParam(), cases_a_motion, [](Case one) {
    for (const Motion& motion : motions)
      expect_moved(one, moved_by_transform(question_of(one), motion), motion, 1);
  });
}

TEST_P(OracleMotionOfFields, ExchangingAndMirroringAxesOfTheFieldsMovesNothingElse) {
  std::size_t exchanged = 0;
  for_each_case(GetParam(), cases_a_motion, [&](Case one) {
    const RayQuestion& asked = question_of(one);
    const auto* polygon = std::get_if<Polygon<double>>(&asked.shape);
    const bool may_exchange = polygon == nullptr || (is_short(one) && is_flat(*polygon));
    if (may_exchange) ++exchanged;
    for (const Motion& motion : motions) {
      if (!may_exchange && !motion.keeps_axes()) continue;
      const double hand = has_handed_normal(asked.shape) ? motion.determinant() : 1;
      expect_moved(one, moved_by_fields(asked, motion), motion, hand);
    }
  });
  EXPECT_GT(exchanged, 300U);
}

void scale_ray(Ray<double>& ray, double factor) {
  ray.origin *= factor;
  ray.direction *= factor;
}

/// The scene in another size: the shape by its fields or, with the world, by its transform.
RayQuestion scaled(RayQuestion asked, double factor, bool by_transform) {
  scale_ray(asked.ray, factor);
  if (!by_transform)
    asked.shape = std::visit([&](const auto& shape) -> Shape { return grown(shape, factor); }, asked.shape);
  if (!by_transform && !asked.transform) return asked;
  glm::dmat4 map = asked.transform.value_or(glm::dmat4(1));
  for (int column = by_transform ? 0 : 3; column < 4; ++column)
    for (int row = 0; row < 3; ++row) map[column][row] *= factor;
  asked.transform = map;
  return asked;
}

TEST_P(OracleMotion, ScalingASceneByAPowerOfTwoScalesNothingButItsPoint) {
  std::size_t tried = 0;
  for_each_case(GetParam(), cases_a_motion, [&](Case one) {
    const RayAnswer before = ray_answer(one);
    if (!is_scalable(one, before)) return;
    ++tried;
    for (const double factor : {0x1p+9, 0x1p-5}) {
      for (const bool by_transform : {false, true}) {
        const RayQuestion asked = scaled(question_of(one), factor, by_transform);
        const RayAnswer after = ray_answer({.precision = one.precision, .question = asked});
        expect_same_meeting(before, after);
        if (before.point && after.point) {
          EXPECT_EQ(factor * *before.point, *after.point);
        }
        if (before.normal && after.normal) expect_near(*before.normal, *after.normal, one.precision);
      }
    }
  });
  EXPECT_GT(tried, 1000U);
}

}  // namespace
}  // namespace rayproof::oracle::test
