#include "subjects/pool.hpp"

#include <gtest/gtest.h>

namespace rayproof {
namespace {

class Idle final : public Answerer {
 public:
  void answer(std::span<const Case> /*cases*/, std::span<Outcome> /*outcomes*/) override {}
};

TEST(Pool, LendsWhatNobodyUsesBeforeItStartsAnother) {
  int started = 0;
  const StartAnswerer start = pooled([&started] {
    ++started;
    return std::make_unique<Idle>();
  });
  { const auto one = start(); }
  { const auto again = start(); }
  EXPECT_EQ(started, 1);
  const auto one = start();
  const auto other = start();
  EXPECT_EQ(started, 2);
}

TEST(Pool, IsSharedByCopiesOfTheFunction) {
  int started = 0;
  const StartAnswerer start = pooled([&started] {
    ++started;
    return std::make_unique<Idle>();
  });
  const StartAnswerer copy = start;
  { const auto one = start(); }
  { const auto again = copy(); }
  EXPECT_EQ(started, 1);
}

}  // namespace
}  // namespace rayproof
