#include <gtest/gtest.h>

#include <cmath>

#include "unit/diagnosis/marks.hpp"

namespace rayproof {
namespace {

constexpr const char* far_sphere =
    R"({"ray": {"origin": [-100,0,0], "direction": [1,0,0]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";

TEST(DiagnosisOfRoots, KnowsThatTheRootThatCancelsDividesC) {
  constexpr const char* from_just_inside =
      R"({"ray": {"origin": [-999.999,0,0], "direction": [1,0,0], "t_min": "-inf"}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1000}})";
  const double near = -0.001, far = 1999.999, product = near * far;
  const auto bears_mark = [&](double x, double y) {
    return bears("divides-by-what-cancels", from_just_inside, with_hits({x, y}));
  };
  const double off = near * (1 + 1e-9);
  EXPECT_EQ(bears_mark(off, product / off), true) << "both are off by the same share";
  EXPECT_EQ(bears_mark(off, far + 1e-3), false);
  const double worse = near * (1 + 1e-6);
  EXPECT_EQ(bears_mark(worse, product / worse), false)
      << "no cancellation loses as much: a wrong number divides";
  EXPECT_EQ(bears_mark(-off, -product / off), false) << "a sign is wrong";
  EXPECT_EQ(bears_mark(near - 1e-4, far + 1e-4), std::nullopt)
      << "the sum is right: -b ± √D with a rounded D";
  EXPECT_EQ(bears_mark(near, far), std::nullopt);
}

TEST(DiagnosisOfHits, KnowsThatAFartherOneIsGivenInPlaceOfTheNearest) {
  const auto bears_mark = [](double t) {
    RayAnswer only = with_hits({t});
    only.nearest_only = true;
    return bears("not-nearest", far_sphere, only);
  };
  EXPECT_EQ(bears_mark(101), true);
  EXPECT_EQ(bears_mark(100), false) << "no surface is there";
  EXPECT_EQ(bears_mark(99), std::nullopt);
  EXPECT_EQ(bears("not-nearest", far_sphere, with_hits({101})), std::nullopt) << "all hits are asked for";
}

TEST(DiagnosisOfTriangles, ForeseesMissesNearEdgesOfAToleranceOfTheWrongSign) {
  const Case near_ab = read_case(
      R"({"precision": "float64", "ray": {"origin": [0.25,0.0005,1], "direction": [0,0,-1]}, "shape": {"type": "triangle", "a": [0,0,0], "b": [1,0,0], "c": [0,1,0]}})");
  const auto are_missed = [&](const char* model) {
    std::vector<bool> missed;
    for (const Answer& answer : find_hypothesis(model)->predict(near_ab, oracle::answer(near_ab)))
      missed.push_back(std::get<RayAnswer>(answer).hits.count == 0);
    return missed;
  };
  EXPECT_EQ(are_missed("edges-tight-1e-3"), (std::vector<bool>{false, false, true, true}))
      << "by alpha, by beta, by gamma alone, by all three";
  EXPECT_EQ(are_missed("edges-tight-1e-4"), (std::vector<bool>{false, false, false, false}));
}

TEST(DiagnosisOfPoints, KnowsAPointThatIsNotOnTheRay) {
  RayAnswer got = with_hits({99});
  got.point = glm::dvec3(99, 101, 0);
  EXPECT_EQ(bears("point-beside-ray", far_sphere, got), true);
  got.point = glm::dvec3(99, 0, 0);
  EXPECT_EQ(bears("point-beside-ray", far_sphere, got), false);
  EXPECT_EQ(bears("point-beside-ray", far_sphere, with_hits({99})), std::nullopt);
}

TEST(DiagnosisOfPoints, KnowsAPointThatIsMovedOffTheSurface) {
  const char* const level =
      R"({"precision": "float64", "ray": {"origin": [0,0,1], "direction": [3,0,-1]}, "shape": {"type": "plane", "normal": [0,0,7], "d": 0}})";
  RayAnswer got = with_hits({1});
  got.point = glm::dvec3(3, 0, 1e-3);
  EXPECT_EQ(bears("point-moved", level, got), true);
  got.point = glm::dvec3(3, 0, -1e-6);
  EXPECT_EQ(bears("point-moved", level, got), true) << "inward";
  got.point = glm::dvec3(3.003, 0, -1e-3);
  EXPECT_EQ(bears("point-moved", level, got), false) << "along the ray";
  got.point = glm::dvec3(3, 0, 0);
  EXPECT_EQ(bears("point-moved", level, got), std::nullopt);
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
