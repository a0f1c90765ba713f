#include "rapidcheck.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <unordered_map>

#include "properties/numbers.hpp"
#include "properties/shrink/simplicity.hpp"
#include "subjects/subject.hpp"

namespace rayproof {
namespace {

/// The answer of a method to a case of either precision.
Answer answer_of(const char* method, const Case& one) { return find_subject(method)->answer(one); }

std::vector<double> hits_of(const Answer& answer) {
  const auto t = std::get<RayAnswer>(answer).hits.view();
  return {t.begin(), t.end()};
}

// t is in units of the direction's length: whoever moves ray and object together keeps every t. A scaling by
// a power of 2 rounds nothing, so that the digits are kept, too.
RC_GTEST_PROP(TransformedObjects, KeepTheirT, ()) {
  const Case one = *cases("sphere", "random");
  const double scale = std::ldexp(1.0, *rc::gen::inRange(-20, 21));
  Case scaled = one;
  auto& asked = std::get<RayQuestion>(scaled.question);
  asked.transform = glm::dmat4(glm::dmat3(scale));
  asked.ray.origin *= scale;
  asked.ray.direction *= scale;

  RC_ASSERT(hits_of(oracle::answer(scaled)) == hits_of(oracle::answer(one)));
  RC_ASSERT(hits_of(answer_of("sphere/centred", scaled)) == hits_of(answer_of("sphere/centred", one)));
}

// For b² >> 4ac the quadratic formula subtracts two nearly equal numbers; Citardauq's form of the smaller
// root adds.
RC_GTEST_PROP(Citardauq, IsStableWhereTheQuadraticFormulaCancels, ()) {
  const Case one = *cases("quadratic", "cancelling");
  const oracle::Judgement judgement = oracle::judge(one, answer_of("quadratic/citardauq", one));
  RC_ASSERT(!judgement.wrong);
  RC_ASSERT(judgement.residual <= find_subject("quadratic/citardauq")->contract.residual.promised);
}

// A point is inside where a ray from it crosses the boundary an odd number of times, whichever way the
// boundary runs.
RC_GTEST_PROP(PointInPolygon, IsInsideWhereTheCrossingsAreOdd, ()) {
  const Case one = *cases("point_in_polygon");
  classify(one);
  Case backwards = one;
  auto& vertices = std::get<PointAndPolygon<double>>(backwards.question).vertices;
  std::reverse(vertices.begin(), vertices.end());
  RC_ASSERT(std::get<Position>(oracle::answer(one)) == std::get<Position>(oracle::answer(backwards)));

  const Contract& contract = find_subject("point_in_polygon/parity")->contract;
  const oracle::Judgement judgement = oracle::judge(one, answer_of("point_in_polygon/parity", one));
  RC_PRE(judgement.smallest >= -contract.domain.reach_float &&
         judgement.largest <= contract.domain.reach_float);
  RC_ASSERT(!judgement.wrong || judgement.margin <= contract.verdict.promised);
}

struct SilentListener : rc::detail::TestListener {
  void onTestCaseFinished(const rc::detail::CaseDescription& /*description*/) override {}
  void onShrinkTried(const rc::detail::CaseDescription& /*shrink*/, bool /*accepted*/) override {}
  void onTestFinished(const rc::detail::TestMetadata& /*metadata*/,
                      const rc::detail::TestResult& /*result*/) override {}
};

/// What rapidcheck finds of a sphere whose radius is taken for twice as large.
Case counterexample_to_a_wrong_radius() {
  Case last;
  rc::detail::TestParams params;
  params.seed = 1;
  SilentListener silent;
  const auto result = rc::detail::checkTestable(
      [&] {
        const Case one = *cases("sphere", "random");
        Case larger = one;
        std::get<Sphere<double>>(std::get<RayQuestion>(larger.question).shape).radius *= 2;
        if (oracle::judge(one, oracle::answer(larger)).wrong) {
          last = one;
          RC_FAIL("wrong");
        }
      },
      rc::detail::TestMetadata{}, params, silent, std::unordered_map<std::string, rc::detail::Reproduce>{});
  EXPECT_TRUE(result.is<rc::detail::FailureResult>());
  return last;
}

TEST(CasesOfRapidcheck, ShrinkToNumbersOfAtMostThreeDigits) {
  Case one = counterexample_to_a_wrong_radius();
  for (const CaseNumber& number : numbers_of(one))
    EXPECT_LE(significant_digits(*number.value, one.precision), 3U) << write_case(one);
}

TEST(CasesOfRapidcheck, AreShownAsOneLineOfTheCaseFormat) {
  const Case one = families().front().generate(1, Precision::float32);
  std::ostringstream shown;
  rc::show(one, shown);
  EXPECT_EQ(shown.str(), write_case(one));
}

TEST(CasesOfRapidcheck, KnowTheFamiliesByName) {
  EXPECT_THROW((void)cases("sphere", "unknown"), std::invalid_argument);
}

}  // namespace
}  // namespace rayproof
