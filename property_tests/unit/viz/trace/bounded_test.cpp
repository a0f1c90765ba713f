#include <gtest/gtest.h>

#include "unit/viz/trace/every_method.hpp"

namespace rayproof::viz {
namespace {

/// The exact value is a number and lies within the bound; infinite bounds enclose everything.
template <class T>
testing::AssertionResult encloses(const Operation<Shadow>& o) {
  if (isnan(o.exact) || std::isinf(o.error_bound)) return testing::AssertionSuccess();
  if (Shadow(o.value) == o.exact) return testing::AssertionSuccess();  // an infinite input too
  const Shadow error = abs(Shadow(o.value) - o.exact);
  if (error <= o.error_bound) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "operation " << static_cast<int>(o.op) << ": " << o.value
                                     << " is off by " << static_cast<double>(error) << ", bound "
                                     << o.error_bound;
}

template <class T>
void expect_enclosed() {
  for_every_recordable_method<T>([]<class Topic, class Method>(const auto& problem) {
    Tape tape;
    (void)Topic::template solve<Method>(convert<Recorded<T, Shadow>>(problem));
    for (const Operation<Shadow>& o : tape.operations) ASSERT_TRUE(encloses<T>(o)) << Method::name;
  });
}

TEST(Bounded, EnclosesTheExactValueOfEveryFloatOperation) { expect_enclosed<float>(); }
TEST(Bounded, EnclosesTheExactValueOfEveryDoubleOperation) { expect_enclosed<double>(); }

TEST(Bounded, IsWithinAFewUlpsForATameFormula) {
  const auto roots = quadratic::Kahan::roots(convert<Bounded<float>>(Quadratic<float>{1, -3, 2}));
  EXPECT_EQ(roots.lo.value, 1);
  EXPECT_LT(roots.lo.error, 1e-5F);
}

TEST(Bounded, SaysNothingOfADivisionByWhatMayBeZero) {
  const auto noise = Bounded<float>::of(1, 2);
  EXPECT_EQ((Bounded<float>(1) / noise).error, INFINITY);
}

TEST(Bounded, SaysNothingAfterOverflow) {
  const Bounded<float> large = 3e38F;
  EXPECT_EQ((large * large).error, INFINITY);
}

TEST(Bounded, ARootNearZeroIsBoundedByTheRootOfTheError) {
  const auto root = sqrt(Bounded<float>::of(0, 1e-6F));
  EXPECT_GE(root.error, 1e-3F);
  EXPECT_LT(root.error, 1.1e-3F);
}

TEST(Bounded, AnUncertainChoiceIsBoundedOverBothBranches) {
  const auto x = Bounded<float>::of(1, 0.5F);
  const auto chosen = select(x < Bounded<float>(1.2F), Bounded<float>(10), Bounded<float>(20));
  EXPECT_EQ(chosen.value, 10);
  EXPECT_GE(chosen.error, 10);
}

TEST(Bounded, ACertainChoiceCostsNothing) {
  const auto x = Bounded<float>::of(1, 0.5F);
  EXPECT_EQ(select(x < Bounded<float>(2), Bounded<float>(10), Bounded<float>(20)).error, 0);
}

TEST(Bounded, ASignThatMayBeEitherReachesOverBoth) {
  const auto noise = Bounded<float>::of(1e-7F, 1e-6F);
  EXPECT_GE(copysign(Bounded<float>(3), noise).error, 6);
}

TEST(Bounded, OrderDoesNotHideWhichRootIsWhich) {
  const auto x0 = Bounded<float>::of(1, 0.5F);
  const auto x1 = Bounded<float>::of(0.9F, 0.01F);
  const auto roots = ascending(Bounded<float>(1), x0, x1);
  // The exact lower root may be as small as x0's lower end.
  EXPECT_LE(roots.lo.value - roots.lo.error, 0.5F);
}

TEST(Bounded, IntegersAndWiderNumbersKeepTheirRoundingAsError) {
  EXPECT_EQ(Bounded<float>(4).error, 0);
  EXPECT_GT(Bounded<float>(0.1).error, 0);
  EXPECT_EQ(Bounded<float>(std::numeric_limits<double>::infinity()).error, 0);
}

}  // namespace
}  // namespace rayproof::viz
