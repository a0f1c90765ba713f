/// \file
/// What an interval promises, against the oracle's exact ring: whatever numbers are taken out of the
/// operands, the exact result is in the result. rapidcheck draws a seed, our own generators the bit patterns.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <iostream>
#include <rayproof/arithmetics/interval.hpp>

#include "generators/draw.hpp"
#include "oracle/numbers/exact.hpp"

namespace rayproof {
namespace {

using oracle::Ring;
using oracle::sign;

/// A finite number: any bits, a special one, or a small whole one.
template <class T>
T number(Random& random) {
  const int choice = random.between(0, 3);
  if (choice == 0) return draw::special<T>(random);
  return choice == 1 ? T(random.between(-5, 5)) : draw::bit_pattern<T>(random);
}

/// An interval and a number in it; sometimes a point, sometimes unbounded.
template <class T>
struct Sample {
  Interval<T> range;
  T inside;
};
template <class T>
Sample<T> sample(Random& random) {
  std::array<T, 3> x{number<T>(random), number<T>(random), number<T>(random)};
  if (random.one_in(4)) return {Interval<T>(x[0]), x[0]};
  std::sort(x.begin(), x.end());
  if (random.one_in(8)) x[0] = -infinity<T>;
  if (random.one_in(8)) x[2] = infinity<T>;
  return {Interval<T>::between(x[0], x[2]), x[1]};
}

/// numerator / denominator, exactly, but never divided.
struct RationalQuotient {
  Ring numerator;
  Ring denominator = Ring(1.0);

  /// The sign of (this - x).
  [[nodiscard]] int compare(double x) const {
    if (std::isinf(x)) return x > 0 ? -1 : 1;
    return sign(numerator - Ring(x) * denominator) * sign(denominator);
  }
};

template <class T>
bool holds(const Interval<T>& range, const RationalQuotient& exact) {
  if (range.is_empty()) return false;
  return exact.compare(range.lo) >= 0 && exact.compare(range.hi) <= 0;
}

/// Runs `check(Random&)` under rapidcheck on fixed seeds; RC_PARAMS has no say. A property fails by an
/// exception.
template <class Check>
void for_all(Check&& check) {
  rc::detail::TestParams params;
  params.seed = 2022;
  params.maxSuccess = 100;
  const auto run = [&] {
    Random random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
    for (int i = 0; i < 100; ++i) check(random);  // one seed, many draws: rapidcheck's own cost is larger
  };
  const auto result = rc::detail::checkTestable(run, rc::detail::TestMetadata(), params);
  rc::detail::SuccessResult success;
  EXPECT_TRUE(result.match(success));
  if (!result.match(success)) rc::detail::printResultMessage(result, std::cerr);
}

template <class T>
class IntervalOf : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(IntervalOf, Precisions);

TYPED_TEST(IntervalOf, HoldsEverySumDifferenceAndProduct) {
  for_all([](Random& random) {
    const auto x = sample<TypeParam>(random), y = sample<TypeParam>(random);
    const Ring a(x.inside), b(y.inside);
    RC_ASSERT(holds(x.range + y.range, {a + b}));
    RC_ASSERT(holds(x.range - y.range, {a - b}));
    RC_ASSERT(holds(x.range * y.range, {a * b}));
    RC_ASSERT(holds(fma(x.range, y.range, x.range), {a * b + a}));
  });
}

TYPED_TEST(IntervalOf, HoldsEveryQuotientByWhatIsNotZero) {
  for_all([](Random& random) {
    const auto x = sample<TypeParam>(random), y = sample<TypeParam>(random);
    if (y.inside != 0) RC_ASSERT(holds(x.range / y.range, {Ring(x.inside), Ring(y.inside)}));
  });
}

TYPED_TEST(IntervalOf, HoldsEverySquareRootAndSize) {
  for_all([](Random& random) {
    const auto x = sample<TypeParam>(random), other = sample<TypeParam>(random);
    const Ring a(x.inside);
    RC_ASSERT(holds(square(x.range), {a * a}));
    RC_ASSERT(square(x.range).lo >= 0);
    RC_ASSERT(holds(abs(x.range), {sign(a) < 0 ? -a : a}));
    RC_ASSERT(copysign(x.range, other.range).contains(std::copysign(x.inside, other.inside)));
    if (x.inside < 0) return;
    const Interval<TypeParam> root = sqrt(x.range);  // lo² <= a <= hi², where lo >= 0
    RC_ASSERT(root.lo >= 0);
    RC_ASSERT(sign(Ring(root.lo) * Ring(root.lo) - a) <= 0);
    // RC_ASSERT evaluates both sides of || and &&, and the ring has no infinity.
    if (std::isfinite(root.hi)) RC_ASSERT(sign(Ring(root.hi) * Ring(root.hi) - a) >= 0);
  });
}

TYPED_TEST(IntervalOf, HoldsTheSmallerTheLargerAndTheChosen) {
  for_all([](Random& random) {
    const auto x = sample<TypeParam>(random), y = sample<TypeParam>(random);
    RC_ASSERT(min(x.range, y.range).contains(std::min(x.inside, y.inside)));
    RC_ASSERT(max(x.range, y.range).contains(std::max(x.inside, y.inside)));
    const TypeParam chosen = x.inside < y.inside ? x.inside : y.inside;
    RC_ASSERT(select(x.range < y.range, x.range, y.range).contains(chosen));
  });
}

TYPED_TEST(IntervalOf, NeverDeniesWhatAComparisonOfItsNumbersSays) {
  const auto allows = [](IntervalMask mask, bool outcome) { return outcome ? mask.may_hold : mask.may_fail; };
  for_all([&](Random& random) {
    const auto x = sample<TypeParam>(random), y = sample<TypeParam>(random);
    RC_ASSERT(allows(x.range < y.range, x.inside < y.inside));
    RC_ASSERT(allows(x.range <= y.range, x.inside <= y.inside));
    RC_ASSERT(allows(x.range > y.range, x.inside > y.inside));
    RC_ASSERT(allows(x.range >= y.range, x.inside >= y.inside));
    RC_ASSERT(allows(x.range == y.range, x.inside == y.inside));
    RC_ASSERT(allows(x.range != y.range, x.inside != y.inside));
    const IntervalMask both = x.range < y.range && x.range == y.range;
    RC_ASSERT(allows(both, x.inside < y.inside && x.inside == y.inside));
    const IntervalMask either = x.range < y.range || x.range == y.range;
    RC_ASSERT(allows(either, x.inside <= y.inside));
  });
}

/// Of points, each end is at most one step beyond the nearest float on its side, and exact results stay
/// points.
TYPED_TEST(IntervalOf, IsNoWiderThanPromised) {
  const auto steps = [](TypeParam x, int count) {  // outward::below is the mirror image of above
    for (; count > 0; --count) x = outward::above(x);
    return x;
  };
  const auto is_tight = [&](const Interval<TypeParam>& z, const RationalQuotient& exact) {
    if (!z.is_bounded()) return true;
    return z.is_point() || (exact.compare(steps(z.lo, 2)) <= 0 && exact.compare(-steps(-z.hi, 2)) >= 0);
  };
  for_all([&](Random& random) {
    const TypeParam x = number<TypeParam>(random), y = number<TypeParam>(random);
    const Interval<TypeParam> a(x), b(y);
    RC_ASSERT(is_tight(a + b, {Ring(x) + Ring(y)}));
    RC_ASSERT(is_tight(a * b, {Ring(x) * Ring(y)}));
    if (y != 0) RC_ASSERT(is_tight(a / b, {Ring(x), Ring(y)}));
    const auto whole = [&] { return Interval<TypeParam>(random.between(-1000, 1000)); };
    const Interval<TypeParam> p = whole(), q = whole(), r = whole();
    RC_ASSERT((p * q + r).is_point());
    RC_ASSERT(sqrt(square(p)).is_point());
  });
}

}  // namespace
}  // namespace rayproof
