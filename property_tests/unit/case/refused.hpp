#pragma once
/// \file
/// Lines that are refused, and with which words.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "case/reader.hpp"
#include "far_sphere.hpp"

namespace rayproof {

/// The far sphere with one thing changed, and what its refusal must say.
struct Wrong {
  std::string_view from, to, field;
  std::string sentence;
};

inline void expect_refused(const std::string& line, std::string_view field, std::string_view sentence) {
  try {
    static_cast<void>(read_case(line));
    ADD_FAILURE() << "not refused: " << line;
  } catch (const RefusedCase& why) {
    EXPECT_EQ(why.field(), field) << line;
    EXPECT_EQ(std::string_view(why.what()), sentence) << line;
  }
}

inline void expect_refused(const std::vector<Wrong>& all) {
  for (const Wrong& wrong : all) {
    expect_refused(replaced(far_sphere, wrong.from, wrong.to), wrong.field, wrong.sentence);
  }
}

}  // namespace rayproof
