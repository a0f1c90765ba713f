#include "bench/scaling/scaling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/scenes/random_scene.hpp"

namespace rayproof::report {
namespace {

TEST(RandomScene, HasAsManyObjectsAsItsNameSaysAndTheSameAlways) {
  for (const std::size_t count : {1, 2, 7, 100}) {
    EXPECT_EQ(random_scene("spheres", count).spheres.size(), count);
    EXPECT_EQ(random_scene("triangles", count).triangles.size(), count);
    const RandomScene mixed = random_scene("mixed", count), again = random_scene("mixed", count);
    EXPECT_EQ(mixed.spheres.size() + mixed.triangles.size(), count);
    EXPECT_LE(mixed.spheres.size() - mixed.triangles.size(), 1U);
    EXPECT_EQ(mixed.spheres.back().center, again.spheres.back().center);
  }
}

TEST(Scaling, OfScenesGoesFromOneToAMillionObjectsAndQuicklyToATenthOfThat) {
  const auto largest = [](const BenchOptions& options) {
    const std::vector<ScalingStep> steps = scenes_scaling(options);
    return std::ranges::max(steps, {}, [](const ScalingStep& one) { return one.pattern.size; }).pattern.size;
  };
  EXPECT_EQ(largest({}), 1'000'000U);
  EXPECT_EQ(largest({.is_quick = true}), 100'000U);
}

TEST(Scaling, TimesAListTreesAndEmbreeByPlainAndByExactMethods) {
  const std::vector<ScalingStep> steps = scenes_scaling({.seconds = 1e-4});
  const auto small = std::ranges::find_if(
      steps, [](const ScalingStep& one) { return one.pattern.shape == "mixed" && one.pattern.size == 3; });
  ASSERT_NE(small, steps.end());
  std::vector<std::string> methods;
  for (const BenchRow& row : small->measure(small->pattern)) {
    EXPECT_GT(row.ns_per_ray, 0);
    EXPECT_GE(row.passes_ns.size(), 5U);
    EXPECT_EQ(row.size, 3U);
    EXPECT_FALSE(row.has_errors());
    methods.push_back(row.method + (row.arrangement == Arrangement::batch ? " of a batch" : ""));
  }
  for (const char* const method :
       {"list", "tree", "exact_list", "exact_tree", "list of a batch", "exact_list of a batch"})
    EXPECT_EQ(std::ranges::count(methods, method), 1) << method;
#ifdef RAYPROOF_HAS_EMBREE
  for (const char* const method : {"tree_in_embree", "exact_tree_in_embree", "embree"})
    EXPECT_EQ(std::ranges::count(methods, method), 1) << method;
#endif
}

TEST(Scaling, OfPolygonsTimesEverySoundMethodAndNoneThatIsWrongAsPrinted) {
  const std::vector<ScalingStep> steps = polygon_scaling({.seconds = 1e-4});
  for (const std::size_t i : {std::size_t{0}, steps.size() - 1}) {
    const std::vector<BenchRow> rows = steps[i].measure(steps[i].pattern);
    EXPECT_GE(rows.size(), 3U);
    for (const BenchRow& row : rows) EXPECT_FALSE(row.method.starts_with("printed")) << row.method;
  }
}

TEST(Scaling, OfThreadsBeginsWithOneAndSharesAllRays) {
  const std::vector<ScalingStep> steps = threads_scaling({.seconds = 1e-4});
  ASSERT_FALSE(steps.empty());
  EXPECT_EQ(steps.front().pattern.size, 1U);
  for (const BenchRow& row : steps.back().measure(steps.back().pattern)) EXPECT_GT(row.ns_per_ray, 0);
}

TEST(Scaling, IsMeasuredUnlessAShapeOrAnotherCurveIsAskedFor) {
  EXPECT_TRUE(BenchOptions{}.wants_scaling("scenes"));
  EXPECT_TRUE(BenchOptions{}.wants_rows());
  EXPECT_FALSE((BenchOptions{.shapes = {"sphere"}}.wants_scaling("scenes")));
  const BenchOptions one_curve{.scaling = {"threads"}};
  EXPECT_TRUE(one_curve.wants_scaling("threads"));
  EXPECT_FALSE(one_curve.wants_scaling("scenes"));
  EXPECT_FALSE(one_curve.wants_rows());
  EXPECT_THROW(validate({.scaling = {"shapes"}}), UnknownFilterName);
}

}  // namespace
}  // namespace rayproof::report
