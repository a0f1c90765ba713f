#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "properties/guests/guest.hpp"

namespace rayproof {
namespace {

/// The judgement on an answer of a guest about a ray and the unit cube.
oracle::Judgement of_cube(const std::string& ray, const RayAnswer& claimed) {
  return judged(read_case(R"({"precision": "float64", "ray": )" + ray +
                          R"(, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})"),
                claimed);
}

RayAnswer hit_at(double t) {
  RayAnswer answer;
  answer.hits.push_back(t);
  answer.nearest_only = true;
  return answer;
}

TEST(JudgedGuest, IsExcusedWhereAPointOnAFaceIsRoundedIntoIt) {
  // Leaves x = 1 at once, and is 2e-17 beyond it where it meets y = 0.
  const char* const beside = R"({"origin": [1,-1,0.5], "direction": [1e-16,5,0.5]})";
  const oracle::Judgement judgement = of_cube(beside, hit_at(0.2));
  EXPECT_TRUE(judgement.wrong);
  EXPECT_LT(judgement.margin, 1);
}

TEST(JudgedGuest, IsNotExcusedWhereARayRunsInAFace) {
  const oracle::Judgement judgement = of_cube(R"({"origin": [0,-1,0.5], "direction": [0,1,0]})", RayAnswer{});
  EXPECT_TRUE(judgement.wrong);
  EXPECT_GT(judgement.margin, 1e6);
}

TEST(JudgedGuest, IsNotExcusedFarFromEveryFace) {
  const oracle::Judgement judgement =
      of_cube(R"({"origin": [0.5,-1,0.5], "direction": [0,1,0]})", RayAnswer{});
  EXPECT_TRUE(judgement.wrong);
  EXPECT_GT(judgement.margin, 1e6);
}

}  // namespace
}  // namespace rayproof
