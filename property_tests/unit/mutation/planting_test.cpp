#include "mutation/planted/planting.hpp"

#include <gtest/gtest.h>

namespace rayproof::mutation {
namespace {

struct Corner {
  double x, y, z;
};

/// What a kernel is that keeps references to its arguments.
struct Kept {
  const Corner& a;
  const Corner& b;
};

Kept kept(const Corner& a, const Corner& b) {
  return {rpm::swapped<40>([&]() -> decltype(auto) { return rpm::lasting(a); },
                           [&]() -> decltype(auto) { return rpm::lasting(b); }),
          rpm::swapped<40>([&]() -> decltype(auto) { return rpm::lasting(b); },
                           [&]() -> decltype(auto) { return rpm::lasting(a); })};
}

class Planting : public testing::Test {
 protected:
  void TearDown() override { state.chosen = -1; }
};

TEST_F(Planting, ChoosesTheMutantInForce) {
  const auto picked = [] { return rpm::pick<7>([] { return 1; }, [] { return 2; }, [] { return 3; }); };
  for (const auto& [chosen, expected] : {std::pair{-1, 1}, {7, 2}, {8, 3}, {9, 1}}) {
    state.chosen = chosen;
    EXPECT_EQ(picked(), expected) << chosen;
  }
}

TEST_F(Planting, LeavesAVariableThatIsKeptByReferenceTheVariable) {
  const Corner p{1, 2, 3}, q{4, 5, 6};
  const Kept own = kept(p, q);
  EXPECT_EQ(&own.a, &p);
  EXPECT_EQ(&own.b, &q);
  state.chosen = 40;
  const Kept exchanged = kept(p, q);
  EXPECT_EQ(&exchanged.a, &q);
  EXPECT_EQ(&exchanged.b, &p);
}

TEST_F(Planting, APartOfWhatIsPickedLastsAsAValue) {
  const Corner p{1, 2, 3}, q{4, 5, 6};
  const auto part = [&]() -> decltype(auto) {
    return rpm::lasting(rpm::pick<60>([&] { return p; }, [&] { return q; }).x);
  };
  static_assert(std::is_same_v<decltype(part()), double>);
  EXPECT_EQ(rpm::swapped<70>(part, [&]() -> decltype(auto) { return rpm::lasting(p.y); }), 1);
  state.chosen = 60;
  EXPECT_EQ(rpm::swapped<70>(part, [&]() -> decltype(auto) { return rpm::lasting(p.y); }), 4);
}

TEST_F(Planting, SwapsNoArgumentsOfTwoTypes) {
  const Corner p{1, 2, 3};
  const double t = 4;
  state.chosen = 50;
  const auto& first = rpm::swapped<50>([&]() -> decltype(auto) { return rpm::lasting(p); },
                                       [&]() -> decltype(auto) { return rpm::lasting(t); });
  EXPECT_EQ(&first, &p);
}

}  // namespace
}  // namespace rayproof::mutation
