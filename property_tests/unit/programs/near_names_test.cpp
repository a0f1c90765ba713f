#include "programs/near_names.hpp"

#include <gtest/gtest.h>

namespace rayproof {
namespace {

TEST(near_names, counts_the_letters_that_must_change) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("centered", "centred"), 1U);
}

TEST(near_names, puts_the_nearest_first) {
  EXPECT_EQ(near_names("sphere/centered", {"sphere/half_b", "sphere/centred", "quadratic/kahan"}, 2),
            (std::vector<std::string>{"sphere/centred", "sphere/half_b"}));
  EXPECT_EQ(near_names("x", {"y"}, 3).size(), 1U);
}

}  // namespace
}  // namespace rayproof
