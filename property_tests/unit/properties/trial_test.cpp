#include "properties/trial.hpp"

#include <gtest/gtest.h>

namespace rayproof {
namespace {

/// A ray at a sphere, whose transform maps x to (1, lean, 0).
Case leaning(double lean, Precision precision) {
  RayQuestion asked{.ray = {{0, 0, -5}, {0, 0, 1}, 0, infinity<double>},
                    .shape = Sphere<double>{{0, 0, 0}, 1}};
  asked.transform = glm::dmat4(1);
  (*asked.transform)[0] = {1, lean, 0, 0};
  return {.precision = precision, .question = asked};
}

TEST(Domain, HasTransformsOfAConditionThatLeavesARayItsDigits) {
  const Subject& plain = *find_subject("sphere/centred");
  for (const auto& [precision, power] :
       {std::pair{Precision::float32, 18}, std::pair{Precision::float64, 47}}) {
    // A lean of 2^k has a condition of about 2^2k.
    const Case inside = leaning(std::ldexp(1.0, power / 2 - 2), precision);
    const Case outside = leaning(std::ldexp(1.0, power / 2 + 1), precision);
    EXPECT_TRUE(Trial(plain, inside).in_domain());
    EXPECT_FALSE(Trial(plain, outside).in_domain());
  }
}

TEST(Domain, OfAMethodThatTakesTheTransformAsksNoCondition) {
  const Case outside = leaning(0x1p10, Precision::float32);
  EXPECT_FALSE(Trial(*find_subject("sphere/centred"), outside).in_domain());
  EXPECT_TRUE(Trial(*find_subject("sphere/rounded"), outside).in_domain());
}

TEST(Domain, AsksNoConditionWhereThereIsNoTransform) {
  Case one = leaning(1, Precision::float32);
  std::get<RayQuestion>(one.question).transform.reset();
  EXPECT_TRUE(Trial(*find_subject("sphere/centred"), one).in_domain());
}

TEST(Condition, IsThatOfFrobeniusNorm) {
  EXPECT_DOUBLE_EQ(condition_of(glm::dmat4(1)), 3);
  EXPECT_FALSE(condition_of(glm::dmat4(0)) <= 1e300);
}

}  // namespace
}  // namespace rayproof
