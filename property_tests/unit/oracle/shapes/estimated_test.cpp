/// \file
/// The quick judgement against the exact one, on all that the families aim at: near and on the edge of every
/// verdict, with numbers of every exponent, zeros and subnormal ones.

#include <cmath>
#include <limits>

#include "oracle/judge/judging.hpp"
#include "oracle/numbers/ulp.hpp"
#include "oracle/shapes/shapes.hpp"
#include "unit/oracle/doubtful.hpp"
#include "unit/oracle/every_case.hpp"

namespace rayproof::oracle::test {
namespace {

using QuickJudge = EveryShape;
INSTANTIATE_TEST_SUITE_P(Of, QuickJudge,
                         testing::Values("plane", "triangle", "polygon", "box", "parallelepiped", "cylinder"),
                         topic_name);

/// Whether a quick error is as good as the oracle promises, to 2^-20 of the exact one, or 2^-30 of a unit.
bool is_as_good(double quick, double exact) {
  if (quick == exact || (std::isnan(quick) && std::isnan(exact))) return true;
  return std::abs(quick - exact) <= std::max(0x1p-20 * std::abs(exact), 0x1p-30);
}

/// All that is exact: an estimate has no part in it.
Judgement exact_judgement(const Case& one, const RayAnswer& claimed) {
  const auto& question = std::get<RayQuestion>(one.question);
  const auto judged = [&](const auto& shape) {
    return judge(*intersection_of(question, shape), one.precision, claimed);
  };
  return std::visit(judged, question.shape);
}

void expect_as_exact(const Case& one, const RayAnswer& claimed) {
  const Judgement quick = judge(one, claimed), exact = exact_judgement(one, claimed);
  EXPECT_EQ(quick.wrong, exact.wrong);
  EXPECT_EQ(quick.hit, exact.hit);
  EXPECT_EQ(quick.smallest, exact.smallest);
  EXPECT_EQ(quick.largest, exact.largest);
  EXPECT_TRUE(is_as_good(quick.far, exact.far)) << quick.far << " " << exact.far;
  EXPECT_TRUE(is_as_good(quick.margin, exact.margin)) << quick.margin << " " << exact.margin;
  EXPECT_TRUE(is_as_good(quick.residual, exact.residual)) << quick.residual << " " << exact.residual;
  EXPECT_TRUE(is_as_good(quick.ulp, exact.ulp)) << quick.ulp << " " << exact.ulp;
}

/// The next number of the case's precision.
double next(double x, Precision precision) {
  if (precision == Precision::float64) return std::nextafter(x, HUGE_VAL);
  return static_cast<double>(std::nextafter(static_cast<float>(x), HUGE_VALF));
}

/// The truth as a claim, one hit too many, and other t.
void try_claims(const Case& one) {
  const RayAnswer truth = ray_answer(one);
  expect_as_exact(one, truth);
  RayAnswer claimed = truth;
  claimed.hits.push_back(1);
  expect_as_exact(one, claimed);
  if (truth.hits.count == 0) return;
  for (const double t : {next(truth.hits.t[0], one.precision), 2 * truth.hits.t[0], 0.0, HUGE_VAL,
                         std::numeric_limits<double>::quiet_NaN()}) {
    claimed = truth;
    claimed.hits.t[0] = t;
    expect_as_exact(one, claimed);
  }
}

TEST_P(QuickJudge, JudgesEveryClaimAsExactNumbersDo) { for_each_case(GetParam(), 40, try_claims); }

/// The maps of the topic's family of transformed cases.
std::vector<glm::dmat4> maps_of(const std::string& topic, Precision precision) {
  std::vector<glm::dmat4> maps;
  for (const Family& family : families())
    for (std::uint64_t seed = 0; family.topic == topic && family.name == "transformed" && seed < 64; ++seed)
      maps.push_back(*std::get<RayQuestion>(family.generate(seed, precision).question).transform);
  return maps;
}

TEST_P(QuickJudge, JudgesEveryClaimUnderAMapAsExactNumbersDo) {
  const std::vector<glm::dmat4> maps[] = {maps_of(GetParam(), Precision::float32),
                                          maps_of(GetParam(), Precision::float64)};
  std::size_t turn = 0;
  for_each_case(GetParam(), 12, [&](Case one) {
    const auto& choice = maps[one.precision == Precision::float32 ? 0 : 1];
    question_of(one).transform = choice.at(++turn % choice.size());
    try_claims(one);
  });
}

TEST(EstimatedSize, KnowsASizeOnlyWhereItsCoordinatesAreKnown) {
  const Vector<Estimate> good{Estimate(3.0), Estimate(4.0), Estimate(0.1) - Estimate(0.1)};
  EXPECT_EQ(length_of(good), 5.0L) << "one that may be 0 does no harm beside others";
  EXPECT_FALSE(is_doubtful([&] { return length_of(good); }));
  const Vector<Estimate> unknown{Estimate(0.1) - Estimate(0.1), 0.0, 0.0};
  EXPECT_TRUE(is_doubtful([&] { return length_of(unknown); }));
}

TEST(EstimatedSize, TakesNoOverflowForANumber) {
  const Estimate huge = Estimate(0x1p1000) * Estimate(0x1p1000);
  EXPECT_TRUE(is_doubtful([&] { return sign(huge); }));
  EXPECT_TRUE(is_doubtful([&] { return approximate(huge); }));
  EXPECT_TRUE(is_doubtful([&] { return length_of(Vector<Estimate>{huge, 0.0, 0.0}); }));
}

}  // namespace
}  // namespace rayproof::oracle::test
