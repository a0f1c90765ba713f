/// \file
/// The oracle judged by itself: scenes of short numbers moved by whole ones, which rounds nothing, and the
/// cylinder, whose axis is fixed, in the motions that are its own.

#include "unit/oracle/every_case.hpp"
#include "unit/oracle/motions.hpp"

namespace rayproof::oracle::test {
namespace {

using OracleStep = EveryShape;
INSTANTIATE_TEST_SUITE_P(Of, OracleStep, testing::ValuesIn(ray_topics()), topic_name);

constexpr std::uint64_t cases_a_step = 100;

/// All vectors of a shape are places but those that the format calls by the name of a direction.
template <class S>
void step(S& shape, const glm::dvec3& by) {
  constexpr std::array<std::string_view, 4> directions{"normal", "u", "v", "edges"};
  ShapeFormat<S>::fields(shape, [&](const char* name, auto& field) {
    if (std::ranges::find(directions, name) != directions.end()) return;
    each_vector(field, [&](glm::dvec3& v) { v += by; });
  });
}
void step(ImplicitPlane& plane, const glm::dvec3& by) { plane.d -= glm::dot(plane.normal, by); }

/// All but the point, which is rounded again in its new place.
void expect_same_but_for_the_point(const RayAnswer& before, const RayAnswer& after) {
  EXPECT_TRUE(std::ranges::equal(before.hits.view(), after.hits.view()));
  EXPECT_EQ(before.contact, after.contact);
  EXPECT_EQ(before.barycentric, after.barycentric);
  EXPECT_EQ(before.normal, after.normal);
}

TEST_P(OracleStep, MovingAWholeSceneByWholeNumbersKeepsTheMeeting) {
  const bool is_fixed = GetParam() == "cylinder";
  const glm::dvec3 by(1000, -77, 1 << 20);
  std::size_t hits = 0;
  for_each_case(GetParam(), cases_a_step, [&](Case one) {
    if (!is_short(one)) return;
    const RayAnswer before = ray_answer(one);
    if (before.hits.count > 0) ++hits;
    const RayQuestion& still = question_of(one);
    RayQuestion by_transform = still;
    by_transform.ray.origin += by;
    by_transform.transform = still.transform.value_or(glm::dmat4(1));
    (*by_transform.transform)[3] += glm::dvec4(by, 0);
    expect_same_but_for_the_point(before, ray_answer({.precision = one.precision, .question = by_transform}));
    if (is_fixed || still.transform) return;
    RayQuestion by_fields = still;
    by_fields.ray.origin += by;
    std::visit([&](auto& shape) { step(shape, by); }, by_fields.shape);
    expect_same_but_for_the_point(before, ray_answer({.precision = one.precision, .question = by_fields}));
  });
  EXPECT_GT(hits, 250U);
}

TEST(CylinderMotion, ExchangingItsRadiiExchangesXAndY) {
  const Motion exchange{{1, 0, 2}, {1, 1, 1}};
  for_each_case("cylinder", cases_a_step, [&](Case one) {
    RayQuestion& asked = question_of(one);
    if (asked.transform) return;
    const RayAnswer before = ray_answer(one);
    asked.ray = moved(asked.ray, exchange);
    auto& tube = std::get<Cylinder<double>>(asked.shape);
    std::swap(tube.rx, tube.ry);
    const RayAnswer after = ray_answer(one);
    EXPECT_TRUE(std::ranges::equal(before.hits.view(), after.hits.view()));
    EXPECT_EQ(before.contact, after.contact);
    if (before.point && after.point) {
      EXPECT_EQ(exchange(*before.point), *after.point);
    }
  });
}

TEST(CylinderMotion, MirroringXAndYChangesNothingButThePoint) {
  const Motion mirror{{0, 1, 2}, {-1, -1, 1}};
  for_each_case("cylinder", cases_a_step, [&](Case one) {
    RayQuestion& asked = question_of(one);
    if (asked.transform) return;
    const RayAnswer before = ray_answer(one);
    asked.ray = moved(asked.ray, mirror);
    const RayAnswer after = ray_answer(one);
    EXPECT_TRUE(std::ranges::equal(before.hits.view(), after.hits.view()));
    EXPECT_EQ(before.contact, after.contact);
    ASSERT_EQ(before.normal.has_value(), after.normal.has_value());
    if (before.normal) {
      EXPECT_EQ(mirror(*before.normal), *after.normal);
    }
  });
}

TEST(CylinderMotion, TurningItUpsideDownChangesNothingButThePoint) {
  for_each_case("cylinder", cases_a_step, [&](Case one) {
    RayQuestion& asked = question_of(one);
    if (asked.transform || !is_short(one)) return;
    const RayAnswer before = ray_answer(one);
    asked.ray.origin.z = std::get<Cylinder<double>>(asked.shape).height - asked.ray.origin.z;
    asked.ray.direction.z = -asked.ray.direction.z;
    const RayAnswer after = ray_answer(one);
    EXPECT_TRUE(std::ranges::equal(before.hits.view(), after.hits.view()));
    EXPECT_EQ(before.contact, after.contact);
    ASSERT_EQ(before.normal.has_value(), after.normal.has_value());
    if (before.normal) {
      EXPECT_EQ(*before.normal * glm::dvec3(1, 1, -1), *after.normal);
    }
  });
}

}  // namespace
}  // namespace rayproof::oracle::test
