#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <rayproof/objects/bounds_tree.hpp>

namespace rayproof::objects {
namespace {

const Bounds cube{{-1, -1, -1}, {1, 1, 1}};

bool is_met(const Ray<double>& ray, double t_max = HUGE_VAL, double margin = 0) {
  return RayAgainstBoxes(ray, margin).entry(cube, t_max) <= t_max;
}

TEST(RayAgainstBoxes, GivesWhereTheRayEnters) {
  EXPECT_NEAR(RayAgainstBoxes({{0, 0, 5}, {0, 0, -1}}).entry(cube, HUGE_VAL), 4, 1e-14);
  EXPECT_EQ(RayAgainstBoxes({{0, 0, 0}, {0, 0, -1}}).entry(cube, HUGE_VAL), 0) << "t_min from inside";
  EXPECT_NEAR(RayAgainstBoxes({{0, 0, 0}, {0, 0, -1}, -HUGE_VAL, 0}).entry(cube, HUGE_VAL), -1, 1e-14);
}

TEST(RayAgainstBoxes, MissesWhatItPasses) {
  EXPECT_TRUE(is_met({{0, 0, 5}, {0, 0, -1}}));
  EXPECT_FALSE(is_met({{0, 0, 5}, {0, 0, 1}})) << "behind the origin";
  EXPECT_FALSE(is_met({{0, 0, 5}, {0, 0, -1}}, 3.9)) << "beyond t_max";
  EXPECT_FALSE(is_met({{0, 0, 5}, {0, 0, -1}, 0, 3.9})) << "beyond the ray's own";
  EXPECT_FALSE(is_met({{0, 1.001, 5}, {0, 0, -1}}));
  EXPECT_FALSE(is_met({{0, 1.001, 5}, {-0.0, 0, -1}})) << "along an axis by a negative zero";
  EXPECT_TRUE(is_met({{0, 1.001, 5}, {0, 0, -1}}, HUGE_VAL, 0.01)) << "within the margin";
}

TEST(RayAgainstBoxes, MeetsTheBoundaryFromAnySide) {
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      EXPECT_TRUE(is_met({{x, y, 5}, {0, 0, -1}})) << "along an edge";
      EXPECT_TRUE(is_met({{x, y, -5}, {-0.0, -0.0, 1}})) << "along an edge, with negative zeros";
      EXPECT_TRUE(is_met({{2 * x, y, 0}, {-x, 0, 0}})) << "within a face";
      EXPECT_TRUE(is_met({{x - 3, y + 3, 1}, {1, -1, 0}})) << "through a corner";
    }
}

TEST(RayAgainstBoxes, RulesNothingOutByNumbersItCannotReasonAbout) {
  constexpr double not_given = not_a_number<double>;
  EXPECT_TRUE(is_met({{not_given, 0, 5}, {0, 0, -1}}));
  EXPECT_TRUE(is_met({{0, 0, 5}, {not_given, 0, -1}}));
  EXPECT_TRUE(is_met({{1e200, 0, 5}, {-1e200, 0, -1}}));
  EXPECT_TRUE(is_met({{9, 0, 5}, {-1e-200, 0, -1}}));
  EXPECT_FALSE(is_met({{1e200, 9, 5}, {-1e200, 0, -1}})) << "but by the others";
  EXPECT_FALSE(is_met({{0, 0, 5}, {0, 0, -1}, not_given, 9})) << "an interval with NaN is empty";
}

/// Boxes here and there, many of them in the same place.
std::vector<Bounds> scattered(std::size_t count) {
  std::mt19937_64 random(count);
  std::uniform_real_distribution<double> place(-10, 10), side(0, 1);
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 low{place(random), place(random), place(random)};
    boxes.push_back(i % 5 == 1 ? boxes.back() : Bounds{low, low + glm::dvec3(side(random), side(random), 0)});
  }
  return boxes;
}

TEST(BoundsTree, AsksEachBoxThatTheRayMeetsOnceAndNoOther) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const std::size_t count : {0U, 1U, 2U, 4U, 5U, 33U, 1000U}) {
    const std::vector<Bounds> boxes = scattered(count);
    const BoundsTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
      const Ray<double> ray{{20 * number(random), 20 * number(random), 20 * number(random)},
                            {number(random), number(random), i % 4 == 0 ? 0 : number(random)}};
      const RayAgainstBoxes against(ray);
      std::vector<int> asked(count), met(count);
      for (std::size_t box = 0; box < count; ++box)
        met[box] = against.entry(boxes[box], HUGE_VAL) <= HUGE_VAL ? 1 : 0;
      tree.visit(against, HUGE_VAL, [&](std::uint32_t box) {
        ++asked[box];
        return HUGE_VAL;
      });
      ASSERT_EQ(asked, met);
    }
  }
}

TEST(BoundsTree, AsksNoBoxBeyondWhatMatters) {
  std::vector<Bounds> row;
  for (int i = 0; i < 100; ++i) row.push_back({{3.0 * i, -1, -1}, {3.0 * i + 1, 1, 1}});
  const BoundsTree tree(row);
  std::vector<std::uint32_t> asked;
  tree.visit(RayAgainstBoxes({{-1, 0, 0}, {1, 0, 0}}), HUGE_VAL, [&](std::uint32_t box) {
    asked.push_back(box);
    return 1.5;
  });
  EXPECT_EQ(asked, std::vector<std::uint32_t>{0}) << "the nearest comes first, and then no other";
  int count = 0;
  tree.visit(RayAgainstBoxes({{-1, 0, 0}, {1, 0, 0}}), HUGE_VAL, [&](std::uint32_t /*box*/) {
    ++count;
    return not_a_number<double>;
  });
  EXPECT_EQ(count, 1) << "NaN ends the search";
}

TEST(BoundsTree, HoldsAThousandBoxesInOnePlaceAndOnesSpreadOverAllSizes) {
  std::vector<Bounds> boxes(1000, cube);
  for (int e = -490; e < 490; ++e) boxes.push_back({{-std::ldexp(1, e), 0, 0}, {std::ldexp(1, e), 1, 1}});
  const BoundsTree tree(boxes);
  std::size_t count = 0;
  tree.visit(RayAgainstBoxes({{0, 0.5, 5}, {0, 0, -1}}), HUGE_VAL, [&](std::uint32_t /*box*/) {
    ++count;
    return HUGE_VAL;
  });
  EXPECT_EQ(count, boxes.size());
}

}  // namespace
}  // namespace rayproof::objects
