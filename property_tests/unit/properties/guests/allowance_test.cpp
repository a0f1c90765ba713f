#include "properties/guests/allowance.hpp"

#include <gtest/gtest.h>

#include "case/reader.hpp"

namespace rayproof {
namespace {

TEST(Allowance, IsOneForWhatPlainArithmeticKeeps) {
  for (
      const char* text :
      {R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})",
       R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "polygon", "vertices": [[5,0,0],[5,1,0],[6,0,0]]}})",
       R"({"query": "quadratic", "a": 1, "b": 2, "c": 3})"}) {
    EXPECT_EQ(allowed_of_hits(read_case(text)), 1) << text;
    EXPECT_EQ(allowed_of_normal(read_case(text)), 1) << text;
  }
}

TEST(Allowance, GrowsWithThePolygonsFirstVertexFarFromTheOthers) {
  const Case one = read_case(
      R"({"ray": {"origin": [0,0,0], "direction": [0,0,1]}, "shape": {"type": "polygon", "vertices": [[0,100,0],[1,0,0],[0,0,0]]}})");
  // In the contracts' unit 100·1; about the first vertex 100·√(100² + 1).
  EXPECT_NEAR(allowed_of_hits(one), 100.005, 1e-3);
  EXPECT_EQ(allowed_of_normal(one), allowed_of_hits(one));
}

TEST(Allowance, OfNormalsGrowsWithTheConditionOfTheMap) {
  const Case one = read_case(
      R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}, "transform": [[1000,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})");
  EXPECT_EQ(allowed_of_hits(one), 1);
  EXPECT_NEAR(allowed_of_normal(one), 1414, 1);  // in Frobenius' norm: about √2 of 1000
}

TEST(Allowance, OfTheNormalOfWhatIsRoundGrowsWithTheDistance) {
  const auto allowed = [](const char* shape, double residual) {
    return allowed_of_normal(
        read_case(std::string(R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": )") + shape +
                  "}"),
        100, residual);
  };
  constexpr auto sphere = R"({"type": "sphere", "center": [0,0,0], "radius": 1})";
  EXPECT_EQ(allowed(sphere, 0.5), 100);
  EXPECT_EQ(allowed(sphere, 30), 3000);  // p of a t that lost digits is no point of the sphere
  EXPECT_EQ(allowed(R"({"type": "box", "min": [0,0,0], "max": [1,1,1]})", 30), 1);
}

TEST(Allowance, OfPointsGrowsWithTheShapeTheConditionOfItsCoordinatesAndOfTheMap) {
  const Case far = read_case(
      R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  EXPECT_DOUBLE_EQ(allowed_of_point(far, 5, 0), 1.1);
  const Case within = read_case(
      R"({"ray": {"origin": [0,0,0], "direction": [0,1,0]}, "shape": {"type": "triangle", "a": [0,0,-1], "b": [3,0,0], "c": [0,0,0.4]}})");
  // From a vertex along the edges, the point (0, 0, 0) is off by a rounding of their lengths.
  EXPECT_GT(allowed_of_point(within, 0, 1), 1e300);
  EXPECT_DOUBLE_EQ(allowed_of_point(within, 1, 100), 301);
  const Case placed = read_case(
      R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "plane", "normal": [0,0,1], "d": 0}, "transform": [[1000,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})");
  EXPECT_NEAR(allowed_of_point(placed, 5, 0), 1414, 1);
}

}  // namespace
}  // namespace rayproof
