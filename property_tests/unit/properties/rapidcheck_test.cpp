#include "rapidcheck.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <sstream>
#include <unordered_map>

#include "properties/numbers.hpp"

namespace rayproof {
namespace {

/// t of every hit, by the oracle or by a method.
std::vector<double> hits_of(const Answer& answer) {
  const auto t = std::get<RayAnswer>(answer).hits.view();
  return {t.begin(), t.end()};
}

// t counts lengths of the direction: where object and ray are stretched alike, every t stays. A power of two
// rounds nothing, so that the method's t stay to the last bit, too.
RC_GTEST_PROP(TransformedObjects, KeepTheirT, ()) {
  const Case one = *cases("sphere", "random");
  const auto power_of_two = [] { return std::ldexp(1.0, *rc::gen::inRange(-20, 21)); };
  const glm::dvec3 factors{power_of_two(), power_of_two(), power_of_two()};
  Case stretched = one;
  auto& asked = std::get<RayQuestion>(stretched.question);
  asked.transform = glm::scale(glm::dmat4(1), factors);
  asked.ray.origin *= factors;
  asked.ray.direction *= factors;

  const Subject& centred = *find_subject("sphere/centred");
  RC_ASSERT(hits_of(oracle::answer(stretched)) == hits_of(oracle::answer(one)));
  RC_ASSERT(hits_of(centred.answer(stretched)) == hits_of(centred.answer(one)));
}

// Where b² >> 4ac, the quadratic formula subtracts two nearly equal numbers; Citardauq's form of the smaller
// root adds.
RC_GTEST_PROP(Citardauq, IsStableWhereTheQuadraticFormulaCancels, ()) {
  const Case one = *cases("quadratic", "cancelling");
  const Subject& citardauq = *find_subject("quadratic/citardauq");
  const oracle::Judgement judgement = oracle::judge(one, citardauq.answer(one));
  RC_ASSERT(!judgement.wrong);
  RC_ASSERT(judgement.residual <= citardauq.contract.residual.promised);
}

// A point is inside where a ray from it crosses the boundary an odd number of times, in whichever direction
// the boundary runs.
RC_GTEST_PROP(PointInPolygon, IsInsideWhereTheCrossingsAreOdd, ()) {
  const Case one = *cases("point_in_polygon");
  classify(one);
  Case backwards = one;
  std::ranges::reverse(std::get<PointAndPolygon<double>>(backwards.question).vertices);

  RC_ASSERT(std::get<Position>(oracle::answer(one)) == std::get<Position>(oracle::answer(backwards)));
  RC_ASSERT(keeps(*find_subject("point_in_polygon/parity"), "verdict", one));
  RC_ASSERT(keeps(*find_subject("point_in_polygon/parity"), "verdict", backwards));
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

TEST(CasesOfRapidcheck, KnowFamiliesAndPropertiesByName) {
  EXPECT_THROW((void)cases("sphere", "unknown"), std::invalid_argument);
  const Case one = families().front().generate(1, Precision::float32);
  EXPECT_THROW((void)keeps(subjects().front(), "unknown", one), std::invalid_argument);
}

TEST(CasesOfRapidcheck, AreJudgedByThePropertiesOfTheCheck) {
  Case far;
  far.precision = Precision::float32;
  far.question = RayQuestion{{{0, 0.2, -4499.9}, {0, 0, 9}}, Sphere<double>{{0, 0, 0}, 1}};
  EXPECT_FALSE(keeps(*find_subject("sphere/textbook"), "robust-verdict", far));
  EXPECT_TRUE(keeps(*find_subject("sphere/centred"), "robust-verdict", far));
}

TEST(CasesOfRapidcheck, TakeANearestTThatIsNotFiniteForAMiss) {
  EXPECT_EQ(nearest_answer(4).hits.view().front(), 4);
  EXPECT_TRUE(nearest_answer(4).nearest_only);
  EXPECT_EQ(nearest_answer(infinity<double>).hits.count, 0U);
  EXPECT_EQ(nearest_answer(not_a_number<double>).hits.count, 0U);
}

}  // namespace
}  // namespace rayproof
