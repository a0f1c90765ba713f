/// \file
/// The oracle judged by itself: changes of a case whose effect on the answer is known without computing it.

#include <gtest/gtest.h>

#include "generators/generators.hpp"
#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

constexpr int cases_per_family = 300;

/// Calls `check(case)` for cases of every sphere family, in both precisions.
template <class Check>
void for_each_sphere(Check&& check) {
  for (const Family& family : families()) {
    if (family.topic != "sphere") continue;
    for (std::uint64_t seed = 0; seed < cases_per_family; ++seed) {
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        SCOPED_TRACE(family.name + " " + std::to_string(seed));
        check(family.generate(seed, precision));
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

void expect_same_hits(const RayAnswer& a, const RayAnswer& b) {
  ASSERT_EQ(a.hits.count, b.hits.count);
  EXPECT_EQ(a.contact, b.contact);
  for (std::size_t i = 0; i < a.hits.count; ++i) EXPECT_EQ(a.hits.t[i], b.hits.t[i]);
}

glm::dvec3 rotated(const glm::dvec3& v) { return {v.y, v.z, v.x}; }

TEST(OracleSymmetry, PermutingTheAxesChangesNothingButTheAxes) {
  for_each_sphere([](Case one) {
    const RayAnswer before = ray_answer(one);
    RayQuestion& question = question_of(one);
    if (question.transform) return;
    auto& sphere = std::get<Sphere<double>>(question.shape);
    question.ray.origin = rotated(question.ray.origin);
    question.ray.direction = rotated(question.ray.direction);
    sphere.center = rotated(sphere.center);
    const RayAnswer after = ray_answer(one);
    expect_same_hits(before, after);
    if (before.point) {
      EXPECT_EQ(rotated(*before.point), *after.point);
    }
  });
}

TEST(OracleSymmetry, MirroringTheDirectionMirrorsTheHits) {
  for_each_sphere([](Case one) {
    RayQuestion& question = question_of(one);
    const RayAnswer before = ray_answer(one);
    question.ray.direction = -question.ray.direction;
    question.ray = {question.ray.origin, question.ray.direction, -question.ray.t_max, -question.ray.t_min};
    const RayAnswer after = ray_answer(one);
    ASSERT_EQ(before.hits.count, after.hits.count);
    for (std::size_t i = 0; i < before.hits.count; ++i) {
      EXPECT_EQ(before.hits.t[i], -after.hits.t[before.hits.count - 1 - i]);
    }
  });
}

TEST(OracleSymmetry, ScalingTheDirectionByAPowerOfTwoScalesT) {
  for_each_sphere([](Case one) {
    RayQuestion& question = question_of(one);
    const RayAnswer before = ray_answer(one);
    for (const double t : before.hits.view()) {
      if (t != 0 && !(std::abs(t) > 0x1p-100 && std::abs(t) < 0x1p+100)) return;
    }
    const double size = glm::length(question.ray.direction);
    if (!(size > 0x1p-100 && size < 0x1p+100)) return;
    question.ray.direction *= 4.0;
    question.ray.t_min /= 4;
    question.ray.t_max /= 4;
    const RayAnswer after = ray_answer(one);
    ASSERT_EQ(before.hits.count, after.hits.count);
    for (std::size_t i = 0; i < before.hits.count; ++i) EXPECT_EQ(before.hits.t[i], 4 * after.hits.t[i]);
  });
}

TEST(OracleSymmetry, AnIdentityTransformChangesNothing) {
  for_each_sphere([](Case one) {
    RayQuestion& question = question_of(one);
    if (question.transform) return;
    const RayAnswer before = ray_answer(one);
    question.transform = glm::dmat4(1);
    const RayAnswer after = ray_answer(one);
    expect_same_hits(before, after);
    if (before.point) {
      EXPECT_EQ(*before.point, *after.point);
    }
  });
}

TEST(OracleSymmetry, MovingRayAndSphereByWholeNumbersKeepsT) {
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 origin(i % 7 - 3, i % 11 - 5, i % 13 - 6);
    const glm::dvec3 direction(i % 5 - 2, i % 3 - 1, 1);
    const glm::dvec3 center(i % 4, i % 6, i % 9);
    const glm::dvec3 away(1000, -77, 1 << 20);
    expect_same_hits(ray_answer(sphere_case(origin, direction, center, i % 8 + 1)),
                     ray_answer(sphere_case(origin + away, direction, center + away, i % 8 + 1)));
  }
}

// Two ways to one answer: the judge finds its error from the power of the point p(t) in filtered arithmetic,
// the answer its t from the roots of the exact quadratic.
TEST(OracleSymmetry, TheJudgeAcceptsTheExactAnswerWithinHalfAnUlp) {
  for_each_sphere([](const Case& one) {
    const Judgement judgement = judge(one, answer(one));
    EXPECT_FALSE(judgement.wrong);
    EXPECT_LE(judgement.ulp, 0.5 + 0x1p-20);
  });
}

TEST(OracleSymmetry, TheJudgeSeesAStepToTheNextFloat) {
  for_each_sphere([](const Case& one) {
    RayAnswer claimed = ray_answer(one);
    if (claimed.hits.count == 0 || !std::isfinite(claimed.hits.t[0])) return;
    const bool narrow = one.precision == Precision::float32;
    double& t = claimed.hits.t[0];
    t = narrow ? static_cast<double>(std::nextafter(static_cast<float>(t), 1e30F)) : std::nextafter(t, 1e300);
    if (!std::isfinite(t)) return;
    const Judgement judgement = judge(one, claimed);
    EXPECT_GE(judgement.ulp, 0.25);  // half an ulp or more of the exact t, whose ulp may be twice as large
    EXPECT_LE(judgement.ulp, 3);
  });
}

}  // namespace
}  // namespace rayproof::oracle::test
