#include "viz/page/page.hpp"

#include <gtest/gtest.h>

namespace rayproof::viz {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Without the rows that only group.
std::string as_math(const std::string& formula) {
  std::string text = math_ml(read_formula(formula));
  for (const std::string row : {"<mrow>", "</mrow>", " stretchy=\"false\"", "<math>", "</math>"})
    for (std::size_t at = text.find(row); at != std::string::npos; at = text.find(row))
      text.erase(at, row.size());
  return text;
}

TEST(MathMl, MakesAFractionOfAQuotientAndDropsTheParenthesesItsBarSpares) {
  EXPECT_EQ(math_ml(read_formula("1/a")),
            "<math><mrow><mfrac><mrow><mn>1</mn></mrow><mrow><mi>a</mi></mrow></mfrac></mrow></math>");
  EXPECT_EQ(
      as_math("(−b − √D) / (2·a)"),
      "<mfrac><mo>−</mo><mi>b</mi><mo>−</mo><msqrt><mi>D</mi></msqrt><mn>2</mn><mo>·</mo><mi>a</mi></mfrac>");
  EXPECT_EQ(as_math("a·(1 / b)"), "<mi>a</mi><mo>·</mo><mfrac><mn>1</mn><mi>b</mi></mfrac>");
  EXPECT_EQ(as_math("(a / b)²"),
            "<msup><mo>(</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>)</mo><mn>2</mn></msup>");
}

TEST(MathMl, PutsAllOfAProductAboveTheBarOfWhatItIsDividedBy) {
  EXPECT_EQ(as_math("2·c / b"), "<mfrac><mn>2</mn><mo>·</mo><mi>c</mi><mi>b</mi></mfrac>");
  EXPECT_EQ(as_math("a / b·c"), "<mfrac><mi>a</mi><mi>b</mi></mfrac><mo>·</mo><mi>c</mi>");
  EXPECT_EQ(as_math("n·(p - o) / (n·d)"),
            "<mfrac><mi>n</mi><mo>·</mo><mo>(</mo><mi>p</mi><mo>−</mo><mi>o</mi><mo>)</mo><mi>n</mi><mo>·</"
            "mo><mi>d</mi></mfrac>");
}

TEST(MathMl, LowersSubscripts) {
  EXPECT_EQ(as_math("t₀"), "<msub><mi>t</mi><mi>0</mi></msub>");
  EXPECT_EQ(as_math("S_x"), "<msub><mi>S</mi><mi>x</mi></msub>");
  EXPECT_EQ(as_math("f.x"), "<msub><mi>f</mi><mi>x</mi></msub>");
  EXPECT_EQ(as_math("up"), "<mi mathvariant=\"normal\">up</mi>");
}

TEST(MathMl, TypesetsANameThatIsAFormulaAsOne) {
  const std::string component = math_ml(named_formula("min - o.x"));
  EXPECT_TRUE(has(component, "<msub><mrow><mo stretchy=\"false\">(</mo>")) << component;
  EXPECT_TRUE(has(component, "<mi>x</mi></msub>")) << component;
  EXPECT_EQ(math_ml(named_formula("p(0).x")).find("<msub><mrow><mi mathvariant=\"normal\">p</mi>"), 12U);
  EXPECT_EQ(math_ml(named_formula("q/a")), math_ml(read_formula("q / a")));
}

TEST(MathMl, FencesBarsVectorsAndCalls) {
  EXPECT_EQ(as_math("|q|²"), "<msup><mo>|</mo><mi>q</mi><mo>|</mo><mn>2</mn></msup>");
  EXPECT_EQ(as_math("(1, 2)"), "<mo>(</mo><mn>1</mn><mo>,</mo><mn>2</mn><mo>)</mo>");
  EXPECT_EQ(as_math("f(x)"), "<mi mathvariant=\"normal\">f</mi><mo>(</mo><mi>x</mi><mo>)</mo>");
  EXPECT_EQ(as_math("dot(a, b)"), "<mi>a</mi><mo>·</mo><mi>b</mi>");
}

TEST(MathMl, KeepsANumbersExponentTogetherAndEscapesWhatHtmlWouldRead) {
  EXPECT_EQ(as_math("1.5e-7"), "<mn>1.5e-7</mn>");
  EXPECT_EQ(as_math("u < 1"), "<mi>u</mi><mo>&lt;</mo><mn>1</mn>");
  EXPECT_EQ(math_ml(number_formula("-3")), "<math><mrow><mo>−</mo><mn>3</mn></mrow></math>");
  EXPECT_EQ(math_ml(nullptr), "<math><mrow></mrow></math>");
}

}  // namespace
}  // namespace rayproof::viz
