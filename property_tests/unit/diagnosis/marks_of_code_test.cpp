#include <gtest/gtest.h>

#include <cmath>

#include "unit/diagnosis/marks.hpp"

namespace rayproof {
namespace {

constexpr const char* far_sphere =
    R"({"ray": {"origin": [-100,0,0], "direction": [1,0,0]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";

TEST(DiagnosisOfRoots, KnowsThatTheRootThatCancelsDividesC) {
  // 99 and 101: the nearer root is off by a share of 1e-6, and 9999 / 99.000099 by the same.
  const double off = 99 * (1 + 1e-6);
  EXPECT_EQ(bears("divides-by-what-cancels", far_sphere, with_hits({off, 9999 / off})), true);
  EXPECT_EQ(bears("divides-by-what-cancels", far_sphere, with_hits({off, 101})), false);
  EXPECT_EQ(bears("divides-by-what-cancels", far_sphere, with_hits({99 - 1e-4, 101 + 1e-4})), std::nullopt)
      << "the sum is right: -b ± √D with a rounded D";
  EXPECT_EQ(bears("divides-by-what-cancels", far_sphere, with_hits({99, 101})), std::nullopt);
}

TEST(DiagnosisOfPoints, KnowsAPointThatIsNotOnTheRay) {
  RayAnswer got = with_hits({99});
  got.point = glm::dvec3(99, 101, 0);
  EXPECT_EQ(bears("point-beside-ray", far_sphere, got), true);
  got.point = glm::dvec3(99, 0, 0);
  EXPECT_EQ(bears("point-beside-ray", far_sphere, got), false);
  EXPECT_EQ(bears("point-beside-ray", far_sphere, with_hits({99})), std::nullopt);
}

TEST(DiagnosisOfPlanes, ForeseesMissesOfGrazingRays) {
  const Case grazing = read_case(
      R"({"ray": {"origin": [0,0,1], "direction": [1000,0,-0.5]}, "shape": {"type": "plane", "normal": [0,0,7], "d": 0}})");
  const auto foreseen = [&](const char* model) {
    return find_hypothesis(model)->predict(grazing, oracle::answer(grazing));
  };
  ASSERT_EQ(foreseen("grazing-missed-1e-3").size(), 1U);
  EXPECT_EQ(std::get<RayAnswer>(foreseen("grazing-missed-1e-3").front()).hits.count, 0U);
  EXPECT_TRUE(foreseen("grazing-missed-1e-4").empty());
}

TEST(DiagnosisOfEdges, KnowsABoxOfMinAndARoundedSize) {
  const char* const above =  // -1e-8 - -1 is rounded to 1
      R"({"precision": "float32", "ray": {"origin": [0,0,-1], "direction": [0,0,1]}, "shape": {"type": "box", "min": [0,-1,0], "max": [1,-1e-8,1]}})";
  RayAnswer found = with_hits({1});
  found.verdict_only = true;
  EXPECT_EQ(bears("rounded-centre", above, found), true);
  EXPECT_EQ(bears("rounded-centre", above, RayAnswer{}), std::nullopt);
}

}  // namespace
}  // namespace rayproof
