#include <cmath>

#include "unit/viz/walkthrough/captions/caption.hpp"
#include "viz/explain/case_report.hpp"

namespace rayproof::viz {
namespace {

/// The balanced equation of full_range has coefficients of its own, without a name.
bool is_balanced(const Said& s) { return s.report.method == "quadratic/full_range"; }
bool is_equation(const Said& s) { return std::holds_alternative<Quadratic<double>>(s.report.one.question); }

const char* root_name(const Said& s, int i) {
  static constexpr const char* names[2][2] = {{"t₀", "t₁"}, {"x₀", "x₁"}};
  return s.n.has("s₀") ? (i == 0 ? "s₀" : "s₁") : names[s.n.has("x₀") ? 1 : 0][i];
}

/// The exact arithmetic has 320 bits: where b² and 4ac are farther apart, it doesn't know the small root.
void expect_solved(const Said& s, double x) {
  const double a = s.n["a"], b = s.n["b"], c = s.n["c"];
  if (!std::isnormal(x) || std::abs(4 * a * c) < 1e-60 * b * b) return;
  EXPECT_TRUE(are_equal((a * x + b) * x + c, 0, std::abs(a * x * x) + std::abs(b * x) + std::abs(c))) << x;
}

/// Of the exact numbers, which no product of a float's can leave.
void expect_sign_of_discriminant(const Said& s) {
  const double rounded = s.n.rounded("D"), exact = s.n["D"];
  const double least = std::abs(s.n["b"] * s.n["b"]), other = std::abs(4 * s.n["a"] * s.n["c"]);
  const bool is_float = s.report.one.precision == Precision::float32;
  const double tiny = is_float ? 1e-30 : 1e-280;
  if (!std::isfinite(rounded) || least < tiny || other < tiny) return;
  EXPECT_EQ(rounded > 0, exact > 0) << exact;
  EXPECT_EQ(rounded < 0, exact < 0) << exact;
}

}  // namespace

std::vector<CheckedClaim> quadratic_claims() {
  return {
      {"Where a is not 0, the sign of D gives the number of real roots: two for D > 0, one for D = 0, none "
       "for D < 0.",
       [](const Said& s) {
         if (!s.n.has("a") || s.n["a"] == 0 || !std::isfinite(s.n["D"])) return;
         const double scale = s.n["b"] * s.n["b"] + std::abs(4 * s.n["a"] * s.n["c"]);
         EXPECT_TRUE(are_equal(s.n["D"], s.n["b"] * s.n["b"] - 4 * s.n["a"] * s.n["c"], scale));
         if (is_equation(s)) {
           const std::size_t roots = s.n["D"] > 0 ? 2 : s.n["D"] == 0 ? 1 : 0;
           EXPECT_EQ(values_of(&s.report.exact).size(), roots) << s.n["D"];
         }
       }},
      {"Where a is not 0 and D ≥ 0, the roots lie √D / |2a| to either side of −b / (2a); where D < 0, √D is "
       "NaN: no real root.",
       [](const Said& s) {
         const double D = s.n.rounded("D");
         EXPECT_EQ(std::isnan(s.n.rounded("√D")), D < 0 || std::isnan(D)) << D;
         if (!s.n.has("a") || s.n["a"] == 0 || !(s.n["D"] >= 0)) return;
         const double a = s.n["a"], b = s.n["b"], root = s.n["√D"], scale = std::abs(b) + root;
         const double x0 = s.n[root_name(s, 0)], x1 = s.n[root_name(s, 1)];
         EXPECT_TRUE(are_equal(a * (x0 + x1), -b, scale));
         EXPECT_TRUE(are_equal(std::abs(a * (x1 - x0)), root, scale));
       }},
      {"2c / (−b ∓ √D) gives the same two roots without a division by a, so one root remains where a = 0.",
       [](const Said& s) {
         if (!(s.n["D"] >= 0)) return;
         if (s.n["a"] == 0 && s.n["b"] != 0 && s.n["c"] != 0) {
           EXPECT_NE(std::isfinite(s.n["x₀"]), std::isfinite(s.n["x₁"]));
         }
         for (const char* name : {"x₀", "x₁"}) expect_solved(s, s.n[name]);
       }},
      {"√D takes the sign of b: two numbers of one sign cannot cancel, so q keeps its digits.",
       [](const Said& s) {
         if (!is_balanced(s) && s.n.has("b") && std::isfinite(s.n["q"]) && s.n["b"] != 0) {
           EXPECT_GE(2 * std::abs(s.n["q"]), (1 - 1e-15) * std::abs(s.n["b"]));
         }
       }},
      {"One root is q / a; by Viète the product of the roots is c / a, so the other one is c / q.",
       [](const Said& s) {
         // The kernel takes a rounded D = 0 for a double root.
         if (is_balanced(s) || !is_equation(s) || !(s.n["D"] > 0) || s.n.rounded("D") == 0) return;
         for (const char* name : {"q/a", "c/q"}) expect_solved(s, s.n[name]);
         EXPECT_TRUE(is_quotient(s.n["q/a"] * s.n["c/q"], s.n["c"], s.n["a"]));
       }},
      {"A fused multiply-add finds the rounding error of 4a·c, and D is corrected by it: so the sign of D is "
       "exact.",
       [](const Said& s) {
         if (!is_balanced(s)) expect_sign_of_discriminant(s);
       }},
      {"With x = 2^k·y the scaled a and c lie between 1/2 and 2, so that their product cannot overflow or "
       "underflow."},
      {"The next steps find y by Kahan's method; then x = 2^k·y, which changes only the exponent."},
      {"Where 4ac is too small to change b², √D is |b| and the roots are −b / a and −c / b; where a = 0, "
       "only −c / b."},
      {"Cancellation depends on b² and 4ac, not on b and 4ac as printed; 'much larger' is taken as 1000 "
       "times."}};
}

}  // namespace rayproof::viz
