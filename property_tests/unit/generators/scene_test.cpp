#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"

namespace rayproof {
namespace {

/// How many numbers `each_number` visits.
template <class V>
int count_numbers(V value) {
  int count = 0;
  each_number(value, [&](double&) { ++count; });
  return count;
}

TEST(EachNumber, VisitsEveryNumberOfAShapeAndNothingElse) {
  EXPECT_EQ(count_numbers(Sphere<double>{}), 4);
  EXPECT_EQ(count_numbers(ImplicitPlane{}), 4);
  EXPECT_EQ(count_numbers(Triangle<double>{}), 9);
  EXPECT_EQ(count_numbers(Polygon<double>{std::vector<glm::dvec3>(5)}), 15);
  EXPECT_EQ(count_numbers(Parallelepiped<double>{}), 12);
  EXPECT_EQ(count_numbers(Cylinder<double>{}), 3);
  EXPECT_EQ(count_numbers(std::vector<Vec2<double>>(3)), 6);
}

TEST(Scenes, RoundingLeavesFloatsAloneAndMakesFloatsOfOtherNumbers) {
  const auto box = rounded(Precision::float32, Box<double>{{0.5, 0.1, -3}, {1e10, 0x1p-140, 2}});
  EXPECT_EQ(box.min, glm::dvec3(0.5, double{0.1F}, -3));
  EXPECT_EQ(box.max, glm::dvec3(1e10, 0x1p-140, 2));
}

TEST(Aim, AnExactLookPassesThroughItsTargetInFloat) {
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    const glm::dvec3 b = whole_point(random, 8), a = whole_point(random, 8);
    const glm::dvec3 target = eighth_between(random, a, b);
    const Scene scene = looked_at_exactly(random, {}, target);
    EXPECT_EQ(rounded(Precision::float32, scene.origin), scene.origin);
    EXPECT_EQ(rounded(Precision::float32, scene.direction), scene.direction);
    EXPECT_EQ(scene.origin + scene.aimed_at * scene.direction, target);
  }
}

TEST(Aim, AWholeVectorIsNotZeroAndOftenRunsAlongAnAxis) {
  Random random(2);
  int along_an_axis = 0;
  for (int k = 0; k < 3000; ++k) {
    const glm::dvec3 v = whole_vector(random, 3);
    EXPECT_NE(v, glm::dvec3(0));
    const int zeros = (v.x == 0 ? 1 : 0) + (v.y == 0 ? 1 : 0) + (v.z == 0 ? 1 : 0);
    along_an_axis += zeros == 2 ? 1 : 0;
  }
  EXPECT_GT(along_an_axis, 900);
}

TEST(Maps, AWholeMapRoundsNothingInAShortSceneAndCarriesTOver) {
  Random random(3);
  for (int k = 0; k < 500; ++k) {
    const glm::dvec3 target = whole_point(random, 8);
    Scene scene = looked_at_exactly(random, {}, target);
    move_exactly(random, Precision::float32, scene);
    EXPECT_EQ(rounded(Precision::float32, scene.origin), scene.origin);
    EXPECT_EQ(rounded(Precision::float32, *scene.transform), *scene.transform);
    const glm::dvec3 moved(*scene.transform * glm::dvec4(target, 1));
    EXPECT_EQ(scene.origin + scene.aimed_at * scene.direction, moved);
    EXPECT_TRUE(is_regular(*scene.transform));
  }
}

RayQuestion ask(const Shape& shape, const glm::dvec3& direction = {0, 0, 1}) {
  return {{glm::dvec3(0), direction}, shape};
}

TEST(Accepted, RefusesWhatTheFormatRefuses) {
  EXPECT_TRUE(is_accepted(ask(Triangle<double>{})));
  EXPECT_FALSE(is_accepted(ask(Triangle<double>{}, glm::dvec3(0))));
  EXPECT_FALSE(is_accepted(ask(ImplicitPlane{})));
  EXPECT_FALSE(is_accepted(ask(Parallelepiped<double>{})));
  EXPECT_FALSE(is_accepted(ask(Cylinder<double>{1, 0, 1, false})));
  RayQuestion singular = ask(Sphere<double>{});
  singular.transform = glm::dmat4(0);
  EXPECT_FALSE(is_accepted(singular));
}

TEST(Accepted, DrawsUntilTheFormatTakesOne) {
  int drawn = 0;
  const RayQuestion asked = first_accepted([&] {
    return ask(Cylinder<double>{1, double{1} * drawn++, 1, false});
  });
  EXPECT_EQ(std::get<Cylinder<double>>(asked.shape).ry, 1);
  EXPECT_EQ(drawn, 2);
}

/// Looks straight at z = 0 from three away.
Scene three_away(Random& /*random*/) {
  return looked_at(ImplicitPlane{{0, 0, 1}, 0}, glm::dvec3(0), {0, 0, 1}, 3, 1);
}

TEST(CutShort, HasAnIntervalThatEndsAtTheHitOrAFewUlpsBeside) {
  Random random(4);
  const Family family = cut_short<three_away>({});
  int at_the_hit = 0;
  for (int k = 0; k < 500; ++k) {
    const auto asked = std::get<RayQuestion>(family.ask(random, Precision::float32));
    const double hit = 3 / asked.ray.direction.z;
    EXPECT_LE(asked.ray.t_min, asked.ray.t_max);
    const double off = std::min(std::abs(asked.ray.t_min - hit), std::abs(asked.ray.t_max - hit));
    EXPECT_LE(off, 4 * 3 * 0x1p-23);
    at_the_hit += off == 0 ? 1 : 0;
  }
  EXPECT_GT(at_the_hit, 200);
  EXPECT_LT(at_the_hit, 500);
}

TEST(AnySize, KeepsTheSceneButForItsSize) {
  Random random(5);
  const Family family = in_any_size<three_away>({});
  std::set<int> exponents;
  for (int k = 0; k < 500; ++k) {
    const auto asked = std::get<RayQuestion>(family.ask(random, Precision::float32));
    EXPECT_EQ(std::get<ImplicitPlane>(asked.shape).normal, glm::dvec3(0, 0, 1));
    EXPECT_LT(asked.ray.origin.z, 0);
    EXPECT_GT(asked.ray.direction.z, 0);
    exponents.insert(std::ilogb(asked.ray.origin.z));
  }
  EXPECT_GT(exponents.size(), 150U);
}

TEST(NumberByNumber, MakesABoxAndACylinderValid) {
  Random random(6);
  for (int k = 0; k < 500; ++k) {
    const auto number = [&] { return draw::bit_pattern<double>(random); };
    EXPECT_TRUE(is_accepted(from_numbers<Box<double>>(random, number)));
    const RayQuestion asked = one_from_numbers<Cylinder<double>>(random, number);
    EXPECT_GT(std::get<Cylinder<double>>(asked.shape).rx, 0);
  }
}

TEST(NumberByNumber, DrawsEveryFormOfAPlane) {
  Random random(7);
  std::set<std::size_t> forms;
  for (int k = 0; k < 100; ++k)
    forms.insert(one_from_numbers<ImplicitPlane, PointNormalPlane, ParametricPlane>(random, [&] {
                   return draw::special<float>(random);
                 }).shape.index());
  EXPECT_EQ(forms.size(), 3U);
}

}  // namespace
}  // namespace rayproof
