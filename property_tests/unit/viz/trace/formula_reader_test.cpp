#include <gtest/gtest.h>

#include "viz/trace/expression.hpp"

namespace rayproof::viz {
namespace {

TEST(FormulaReader, ReadsWhatItsTextPrints) {
  for (const char* text :
       {"(−b − √D) / (2·a)", "|p − C|² − r²", "n·(p − o)", "2.5·|d|", "dot(a, b) + fma(a, b, −c)", "x·2^(n)",
        "t = −1.5e-7", "u ≤ 1", "p(t₀)", "(4, 2)", "a × (b × c)", "a, b", "|a|·|b|"}) {
    EXPECT_EQ(text_of(read_formula(text)), text);
  }
}

TEST(FormulaReader, BindsAQuotientWithoutSpacesTighter) {
  EXPECT_EQ(text_of(read_formula("2·c / b")), "2·c / b");
  EXPECT_EQ(text_of(read_formula("a·1/b")), "a·(1 / b)");
  EXPECT_EQ(text_of(read_formula("−D/4a")), "−D / 4a");
}

TEST(FormulaReader, EndsOnAnyText) {
  for (const char* text :
       {"",  "(",  ")", "((", "())", "√",  "|", "||",  "a)b", "dot(", "dot(a", "dot(a,", "f()",  "^(",
        "/", "1/", "²", "·",  ",",   "·,", "+", "= −", "a b", "−−",   "√²",    "|a, b",  "(a, b"}) {
    EXPECT_NE(read_formula(text), nullptr) << text;
    (void)text_of(read_formula(text));
  }
}

}  // namespace
}  // namespace rayproof::viz
