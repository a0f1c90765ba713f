#include "command_line/progress_line.hpp"

#include <gtest/gtest.h>

namespace rayproof {
namespace {

TEST(ProgressLine, SaysHowLongTheRestTakes) {
  EXPECT_EQ(time_to_go(0, 0.005, 60), "just begun");
  EXPECT_EQ(time_to_go(0, 0.25, 60), "3:00 to go");
  EXPECT_EQ(time_to_go(0, 1, 60), "0:00 to go");
}

/// A campaign of which half had been done was said to end within a minute, whatever was left.
TEST(ProgressLine, TakesNoTimeForWhatAnEarlierRunHasDone) {
  EXPECT_EQ(time_to_go(0.5, 0.504, 60), "just begun");
  EXPECT_EQ(time_to_go(0.5, 0.6, 60), "4:00 to go");
}

}  // namespace
}  // namespace rayproof
