/// \file
/// The oracle judged by itself: changes of a case whose effect on the answer is known without computing it.

#include "unit/oracle/every_case.hpp"
#include "unit/oracle/motions.hpp"

namespace rayproof::oracle::test {
namespace {

using OracleSymmetry = EveryShape;
INSTANTIATE_TEST_SUITE_P(Of, OracleSymmetry, testing::ValuesIn(ray_topics()), topic_name);

constexpr std::uint64_t cases_a_symmetry = 150;

void expect_same_hits(const RayAnswer& a, const RayAnswer& b) {
  ASSERT_EQ(a.hits.count, b.hits.count);
  EXPECT_EQ(a.contact, b.contact);
  for (std::size_t i = 0; i < a.hits.count; ++i) EXPECT_EQ(a.hits.t[i], b.hits.t[i]);
}

TEST_P(OracleSymmetry, MirroringTheDirectionMirrorsTheHits) {
  for_each_case(GetParam(), cases_a_symmetry, [](Case one) {
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

TEST_P(OracleSymmetry, ScalingTheDirectionByAPowerOfTwoScalesT) {
  std::size_t tried = 0;
  for_each_case(GetParam(), cases_a_symmetry, [&](Case one) {
    RayQuestion& question = question_of(one);
    const RayAnswer before = ray_answer(one);
    if (!is_scalable(one, before)) return;
    ++tried;
    question.ray.direction *= 4.0;
    question.ray.t_min /= 4;
    question.ray.t_max /= 4;
    const RayAnswer after = ray_answer(one);
    ASSERT_EQ(before.hits.count, after.hits.count);
    for (std::size_t i = 0; i < before.hits.count; ++i) EXPECT_EQ(before.hits.t[i], 4 * after.hits.t[i]);
  });
  EXPECT_GT(tried, 2500U);
}

TEST_P(OracleSymmetry, AnIdentityTransformChangesNothing) {
  for_each_case(GetParam(), cases_a_symmetry, [](Case one) {
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

// Two ways to one answer: the judge finds its error from the power of the point p(t) in filtered arithmetic,
// the answer its t from the roots of the exact quadratic.
TEST_P(OracleSymmetry, TheJudgeAcceptsTheExactAnswerWithinHalfAnUlp) {
  for_each_case(GetParam(), cases_a_symmetry, [](const Case& one) {
    const Judgement judgement = judge(one, answer(one));
    EXPECT_FALSE(judgement.wrong);
    EXPECT_LE(judgement.ulp, 0.5 + 0x1p-20);
  });
}

TEST_P(OracleSymmetry, TheJudgeSeesAStepToTheNextFloat) {
  for_each_case(GetParam(), cases_a_symmetry, [](const Case& one) {
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
