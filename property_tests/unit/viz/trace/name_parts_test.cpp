#include "viz/trace/expression.hpp"

#include <gtest/gtest.h>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {
namespace {

TEST(NameParts, AreLettersAndIndex) {
  const auto expect = [](const char* name, const char* letters, const char* index) {
    const NameParts parts = parts_of_name(name);
    EXPECT_EQ(parts.letters, letters) << name;
    EXPECT_EQ(parts.index, index) << name;
  };
  expect("t", "t", "");
  expect("t₀", "t", "0");
  expect("S_x", "S", "x");
  expect("f.x", "f", "x");
  expect("e₁.x", "e", "1x");
  expect("o′", "o′", "");
  expect("₀", "₀", "");
}

TEST(NameParts, KnowAVectorByItsComponents) {
  EXPECT_EQ(vector_of("f.x", 'x'), "f");
  EXPECT_EQ(vector_of("f.x", 'y'), "");
  EXPECT_EQ(vector_of(".x", 'x'), "");
  EXPECT_EQ(without_axis("min - o.z"), "min - o");
  EXPECT_EQ(without_axis("p(2.5)"), "p(2.5)");
}

/// "t_c" as "t[c]".
std::string lowered(const std::string& line) {
  std::string text;
  for (const TextRun& run : runs_of(line)) text += run.is_low ? "[" + run.text + "]" : run.text;
  return text;
}

TEST(TextRuns, LowerTheIndexOfANameAndNothingElse) {
  EXPECT_EQ(lowered("t_c"), "t[c]");
  EXPECT_EQ(lowered("t_c = 3, D_β·half_w"), "t[c] = 3, D[β]·half[w]");
  EXPECT_EQ(lowered("t = x_in"), "t = x[in]");
  for (const char* plain : {"", "_", "a_", "_a", "polygon::cross_side", "point_in_polygon", "a b", "t₀"})
    EXPECT_EQ(lowered(plain), plain);
}

}  // namespace
}  // namespace rayproof::viz
