#include "case/reader/near_names.hpp"

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

TEST(near_names, takes_the_one_name_near_enough_for_the_likely_one) {
  const std::vector<std::string> names{"center", "radius", "type", "min", "max", "direction"};
  EXPECT_EQ(likely_name("centre", names), "center") << "two of six letters differ";
  EXPECT_EQ(likely_name("Radius", names), "radius") << "whatever the case of the letters";
  EXPECT_EQ(likely_name("dir", names), "direction") << "a beginning";
  EXPECT_EQ(likely_name("di", names), std::nullopt) << "a beginning of too few letters";
  EXPECT_EQ(likely_name("kind", names), std::nullopt) << "too far from all of them";
  EXPECT_EQ(likely_name("mix", names), std::nullopt) << "as near to min as to max";
  EXPECT_EQ(likely_name("fov_y", {"fov_x", "eye"}), std::nullopt) << "a name of its own";
  EXPECT_EQ(likely_name("", names), std::nullopt);
  EXPECT_EQ(likely_name("min", {}), std::nullopt);
}

}  // namespace
}  // namespace rayproof
