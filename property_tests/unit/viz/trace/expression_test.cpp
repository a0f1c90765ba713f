#include "viz/trace/expression.hpp"

#include <gtest/gtest.h>

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

Formula name(const char* text) { return named_formula(text); }
Formula product(const Formula& a, const Formula& b) { return make(Kind::product, {a, b}); }
Formula quotient(const Formula& a, const Formula& b) { return make(Kind::quotient, {a, b}); }
Formula sum(const Formula& a, const Formula& b) { return with_term(a, "+", b); }
Formula difference(const Formula& a, const Formula& b) { return with_term(a, "−", b); }
Formula negation(const Formula& a) { return with_term(nullptr, "−", a); }

TEST(Expression, PutsParenthesesWhereAnOperandBindsLooserThanItsOperator) {
  const Formula a = name("a"), b = name("b"), c = name("c");
  EXPECT_EQ(text_of(product(sum(a, b), c)), "(a + b)·c");
  EXPECT_EQ(text_of(sum(product(a, b), c)), "a·b + c");
  EXPECT_EQ(text_of(sum(sum(a, b), c)), "a + b + c");
  EXPECT_EQ(text_of(sum(a, sum(b, c))), "a + (b + c)");
  EXPECT_EQ(text_of(difference(a, difference(b, c))), "a − (b − c)");
  EXPECT_EQ(text_of(product(quotient(a, b), c)), "a / b·c");
  EXPECT_EQ(text_of(product(a, quotient(b, c))), "a·(b / c)");
  EXPECT_EQ(text_of(quotient(a, product(b, c))), "a / (b·c)");
  EXPECT_EQ(text_of(quotient(product(a, b), c)), "a·b / c");
  EXPECT_EQ(text_of(make(Kind::cross, {sum(a, b), product(b, c)})), "(a + b) × (b·c)");
}

TEST(Expression, NegatesSumsInParenthesesAndProductsWithout) {
  const Formula a = name("a"), b = name("b"), minus_3 = number_formula("-3");
  EXPECT_EQ(text_of(negation(product(a, b))), "−a·b");
  EXPECT_EQ(text_of(negation(sum(a, b))), "−(a + b)");
  EXPECT_EQ(text_of(difference(negation(a), b)), "−a − b");
  EXPECT_EQ(text_of(difference(a, negation(b))), "a − −b");
  EXPECT_EQ(text_of(difference(a, minus_3)), "a − (-3)");
  EXPECT_EQ(text_of(product(minus_3, minus_3)), "(-3)·(-3)");
  EXPECT_EQ(text_of(difference(minus_3, a)), "-3 − a");
}

TEST(Expression, NestsRootsPowersBarsAndCalls) {
  const Formula a = name("a"), b = name("b"), root = make(Kind::root, {sum(a, make(Kind::root, {b}))});
  EXPECT_EQ(text_of(root), "√(a + √b)");
  EXPECT_EQ(text_of(make(Kind::square, {sum(a, b)})), "(a + b)²");
  EXPECT_EQ(text_of(make(Kind::power, {a, negation(b)})), "a^(−b)");
  EXPECT_EQ(text_of(make(Kind::absolute, {difference(a, b)})), "|a − b|");
  EXPECT_EQ(text_of(make(Kind::call, {a, sum(a, b)}, "copysign")), "copysign(a, a + b)");
  EXPECT_EQ(text_of(nullptr), "");
}

TEST(Expression, TakesANameForTheFormulaThatItIs) {
  const Formula c = name("c");
  EXPECT_EQ(text_of(product(c, name("n·o + d"))), "c·(n·o + d)");
  EXPECT_EQ(text_of(product(c, name("U+V+W"))), "c·(U+V+W)");
  EXPECT_EQ(text_of(product(name("1/a"), c)), "(1/a)·c");
  EXPECT_EQ(text_of(product(name("p(2.5)"), c)), "p(2.5)·c");
  EXPECT_EQ(text_of(product(name("min - o.x"), c)), "(min - o).x·c");
}

TEST(Expression, PutsNumbersInThePlaceOfNames) {
  const Formula d = named_formula("d", {1, 0.5, -2}), t = named_formula("t", {-3}),
                half = number_formula("0.5", {0.5});
  const auto numbers = [](const Formula& f) { return text_of(with_numbers(f, Precision::float32)); };
  EXPECT_EQ(numbers(sum(product(t, d), half)), "(-3)·(1, 0.5, -2) + 0.5");
  EXPECT_EQ(numbers(make(Kind::dot, {d, d})), "dot((1, 0.5, -2), (1, 0.5, -2))");
  EXPECT_EQ(numbers(named_formula("n·o + d", {4})), "4");
  EXPECT_EQ(with_numbers(nullptr, Precision::float32), nullptr);
}

TEST(Expression, PartsASumIntoTermsWithTheirSigns) {
  std::vector<std::string> terms;
  for (const Formula& term : terms_of(read_formula("b·b − 4·(a + c) + |p − q|")))
    terms.push_back(text_of(term));
  EXPECT_EQ(terms, (std::vector<std::string>{"b·b", "−4·(a + c)", "+|p − q|"}));
  EXPECT_EQ(terms_of(name("b")).size(), 1U);
}

TEST(VectorFormula, FindsTheFormulaThatComponentsHaveInCommon) {
  const auto of = [](const char* x, const char* y, const char* z) {
    return text_of(vector_formula({read_formula(x), read_formula(y), read_formula(z)}));
  };
  EXPECT_EQ(of("o.x − C.x", "o.y − C.y", "o.z − C.z"), "o − C");
  EXPECT_EQ(of("t·(o.x + C.x)", "t·(o.y + C.y)", "t·(o.z + C.z)"), "t·(o + C)");
  EXPECT_EQ(of("a.y·b.z − a.z·b.y", "a.z·b.x − a.x·b.z", "a.x·b.y − a.y·b.x"), "a × b");
  EXPECT_EQ(of("a.y·b.z − a.z·b.y", "a.z·b.x − a.x·b.z", "a.x·b.y − a.y·c.x"), "");
  EXPECT_EQ(of("a.x", "a.y + 1", "a.z"), "");
  EXPECT_EQ(of("t", "t", "t"), "");
  EXPECT_EQ(vector_formula({name("a.x"), nullptr, nullptr}), nullptr);
  const Formula a =
      vector_formula({named_formula("a.x", {1}), named_formula("a.y", {2}), named_formula("a.z", {3})});
  EXPECT_EQ(text_of(with_numbers(a, Precision::float32)), "(1, 2, 3)");
}

TEST(VectorFormula, ReadsADotProductBackFromItsThreeTerms) {
  EXPECT_EQ(text_of(dot_or(read_formula("a.x·b.x + a.y·b.y + a.z·b.z"))), "dot(a, b)");
  EXPECT_EQ(text_of(dot_or(read_formula("n.x·(p.x − o.x) + n.y·(p.y − o.y) + n.z·(p.z − o.z)"))),
            "dot(n, p − o)");
  for (const char* other : {"a.x·b.x + a.y·b.y", "a.x·b.x + a.y·b.y + a.z·c.z", "a.x·b.x − a.y·b.y − a.z·b.z",
                            "|a.x|·b.x + |a.y|·b.y + |a.z|·b.z"})
    EXPECT_EQ(text_of(dot_or(read_formula(other))), other);
}

}  // namespace
}  // namespace rayproof::viz
