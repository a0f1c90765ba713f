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
  return {rpm::swapped<40>([&]() -> decltype(auto) { return (a); }, [&]() -> decltype(auto) { return (b); }),
          rpm::swapped<40>([&]() -> decltype(auto) { return (b); }, [&]() -> decltype(auto) { return (a); })};
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

TEST_F(Planting, HandsOnAPartOfATemporaryByValue) {
  const Corner p{1, 2, 3}, q{4, 5, 6};
  const auto swapped = [&] {
    return rpm::swapped<70>([&] { return rpm::pick<60>([&] { return p; }, [&] { return q; }).x; },
                            [&]() -> decltype(auto) { return (p.y); });
  };
  for (const auto& [chosen, expected] : {std::pair{-1, 1}, {60, 4}, {70, 2}}) {
    state.chosen = chosen;
    EXPECT_EQ(swapped(), expected) << chosen;
  }
}

TEST_F(Planting, SwapsNoArgumentsOfTwoTypes) {
  const Corner p{1, 2, 3};
  const double t = 4;
  state.chosen = 50;
  const auto& first =
      rpm::swapped<50>([&]() -> decltype(auto) { return (p); }, [&]() -> decltype(auto) { return (t); });
  EXPECT_EQ(&first, &p);
}

}  // namespace
}  // namespace rayproof::mutation
