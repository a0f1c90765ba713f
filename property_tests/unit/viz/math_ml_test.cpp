#include <gtest/gtest.h>

#include "viz/page/math_ml.hpp"
#include "viz/trace/vector_formula.hpp"

namespace rayproof::viz {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(MathMl, MakesAFractionOfAQuotientAndDropsTheParenthesesItsBarSpares) {
  EXPECT_EQ(math_ml("1/a"), "<math><mrow><mfrac><mn>1</mn><mi>a</mi></mfrac></mrow></math>");
  const std::string root = math_ml("(−b − √D) / (2·a)");
  EXPECT_TRUE(has(root, "<mfrac>")) << root;
  EXPECT_TRUE(has(root, "<msqrt><mi>D</mi></msqrt>")) << root;
  EXPECT_FALSE(has(root, "(")) << root;
}

TEST(MathMl, PutsAllOfAProductAboveTheBarOfWhatItIsDividedBy) {
  EXPECT_EQ(math_ml("2·c / b"),
            "<math><mrow><mfrac><mrow><mn>2</mn><mo>·</mo><mi>c</mi></mrow><mi>b</mi></mfrac></mrow></math>");
  EXPECT_EQ(math_ml("a / b·c"),
            "<math><mrow><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>·</mo><mi>c</mi></mrow></math>");
  EXPECT_EQ(math_ml("a·1/b"),
            "<math><mrow><mi>a</mi><mo>·</mo><mfrac><mn>1</mn><mi>b</mi></mfrac></mrow></math>");
  EXPECT_TRUE(has(math_ml("n·(p - o) / (n·d)"), "<mfrac><mrow><mi>n</mi><mo>·</mo>"))
      << math_ml("n·(p - o) / (n·d)");
}

TEST(MathMl, LowersSubscriptsAndPutsArrowsAbove) {
  EXPECT_TRUE(has(math_ml("t₀"), "<msub><mi>t</mi><mi>0</mi></msub>"));
  EXPECT_TRUE(has(math_ml("S_x"), "<msub><mi>S</mi><mi>x</mi></msub>"));
  EXPECT_TRUE(has(math_ml("f.x"), "<msub><mi>f</mi><mi>x</mi></msub>"));
  EXPECT_TRUE(has(math_ml("d\u20d7"), "<mover>"));
}

TEST(MathMl, ClosesABarOnlyBehindAnOperandInBars) {
  const std::string length =
      "<mo stretchy=\"false\">|</mo><mrow><mi>q</mi></mrow><mo stretchy=\"false\">|</mo>";
  EXPECT_TRUE(has(math_ml("|q|²"), length + "</mrow></mrow><mn>2</mn></msup>")) << math_ml("|q|²");
  EXPECT_TRUE(has(math_ml("r − |q|"), length)) << math_ml("r − |q|");
  EXPECT_TRUE(has(math_ml("(|q| − r)"), length)) << math_ml("(|q| − r)");
}

TEST(MathMl, KeepsASignOfManyBytesWhole) { EXPECT_TRUE(has(math_ml("²"), ">²<")) << math_ml("²"); }

TEST(MathMl, KeepsANumbersExponentTogetherAndEscapesWhatHtmlWouldRead) {
  EXPECT_TRUE(has(math_ml("1.5e-7"), "<mn>1.5e-7</mn>"));
  EXPECT_TRUE(has(math_ml("u < 1"), "&lt;"));
}

TEST(MathMl, PartsAFormulaIntoTermsWithTheirSigns) {
  const std::vector<std::string> terms{"b·b", "− 4·(a + c)", "+ 1"};
  EXPECT_EQ(terms_of("b·b − 4·(a + c) + 1"), terms);
  EXPECT_EQ(terms_of("−b"), std::vector<std::string>{"−b"});
  EXPECT_EQ(terms_of(""), std::vector<std::string>{""});
}

TEST(MathMl, EndsOnAnyText) {
  for (const char* text :
       {"", "(", ")", "((", "√", "|", "a)b", "dot(", "dot(a", "^(", "/", "1/", "²", "·", ","}) {
    EXPECT_TRUE(has(math_ml(text), "</math>")) << text;
  }
}

TEST(VectorFormula, ReadsComponentsBackAsOneFormula) {
  EXPECT_EQ(vector_formula({"o.x − C.x", "o.y − C.y", "o.z − C.z"}), "o − C");
  EXPECT_EQ(vector_formula({"a.y·b.z − a.z·b.y", "a.z·b.x − a.x·b.z", "a.x·b.y − a.y·b.x"}), "a × b");
  EXPECT_EQ(vector_formula({"a.x", "a.y + 1", "a.z"}), "");
}

TEST(VectorFormula, PutsNumbersInThePlaceOfWholeNamesAlone) {
  const auto number_of = [](const std::string& name) {
    return name == "t" ? "2" : name == "t_c" ? "3" : std::string();
  };
  EXPECT_EQ(put_in("t + t_c·d", number_of), "2 + 3·d");
}

}  // namespace
}  // namespace rayproof::viz
