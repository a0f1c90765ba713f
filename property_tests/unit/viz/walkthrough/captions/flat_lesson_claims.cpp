#include <cmath>

#include "oracle/oracle.hpp"
#include "unit/viz/walkthrough/captions/lesson_caption.hpp"
#include "viz/explain/case_report.hpp"

namespace rayproof::viz {
namespace {

/// Twice the signed area of three points of the plane.
double doubled_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void expect_part(const LessonSaid& s, const char* name, const char* from, const char* to) {
  const double whole = doubled_area(s.n.vector("a"), s.n.vector("b"), s.n.vector("c"));
  const double part = doubled_area(s.n.vector("q"), s.n.vector(from), s.n.vector(to));
  EXPECT_TRUE(are_equal(s.n[name], part / whole, 1)) << name;
  // Beyond an edge is on the other side of it than the third vertex.
  EXPECT_EQ(s.n[name] < 0, part * whole < 0);
}

bool is_close(double a, double b, double scale) { return std::abs(a - b) <= 1e-6 * std::abs(scale); }

}  // namespace

std::vector<LessonClaim> flat_lesson_claims() {
  return {
      {"barycentric", "Its sign is + where a, b, c run counterclockwise.",
       [](const LessonSaid& s) {
         const double whole = doubled_area(s.n.vector("a"), s.n.vector("b"), s.n.vector("c"));
         EXPECT_TRUE(are_equal(s.n["D"], whole, whole));
       }},
      {"barycentric", "Where D = 0 the triangle is seen edge-on, and no share exists."},
      {"barycentric",
       "α is the signed area of q, b, c over that of the whole: negative where q is beyond bc.",
       [](const LessonSaid& s) { expect_part(s, "α", "b", "c"); }},
      {"barycentric",
       "β is the signed area of q, c, a over that of the whole: negative where q is beyond ca.",
       [](const LessonSaid& s) { expect_part(s, "β", "c", "a"); }},
      {"barycentric",
       "The three signed areas add up to the whole, so α + β + γ = 1: γ is negative where q is beyond ab.",
       [](const LessonSaid& s) {
         expect_part(s, "γ", "a", "b");
         EXPECT_TRUE(are_equal(s.n["α"] + s.n["β"] + s.n["γ"], 1, 1));
       }},
      {"plane-parallel", "Here the progress is 0, and the distance is not: t is infinite.",
       [](const LessonSaid& s) {
         EXPECT_EQ(s.n["n·d"], 0);
         EXPECT_NE(s.n["n·(p - o)"], 0);
         EXPECT_TRUE(std::isinf(s.n["t"]));
       }},
      {"plane-inside", "Here both are 0, and 0/0 is NaN.",
       [](const LessonSaid& s) {
         EXPECT_EQ(s.n["n·d"], 0);
         EXPECT_EQ(s.n["n·(p - o)"], 0);
         EXPECT_TRUE(std::isnan(s.n["t"]));
       }},
      {"", "4ac is tiny beside b², so nothing cancels yet: √D is nearly |b|.",
       [](const LessonSaid& s) {
         const double b = s.n["b"];
         EXPECT_LT(std::abs(4 * s.n["a"] * s.n["c"]), 1e-4 * b * b);
         EXPECT_TRUE(is_close(std::sqrt(s.n["D"]), std::abs(b), 10 * b));
       }},
      {"quadratic-linear", "With a = 0 it is b² and says nothing of the number of roots: a line has one.",
       [](const LessonSaid& s) {
         EXPECT_EQ(s.n["a"], 0);
         EXPECT_EQ(s.n["D"], s.n["b"] * s.n["b"]);
       }},
      {"quadratic-linear", "−b and √D are equal here: their difference is 0, and 2c / 0 is no root.",
       [](const LessonSaid& s) {
         EXPECT_EQ(-s.n["b"], s.n["√D"]);
         EXPECT_NE(std::isfinite(s.n.rounded("x₀")), std::isfinite(s.n.rounded("x₁")));
       }},
      {"printed-lambda2",
       "Printed is λ₂ = (−(a.y − c.y)·(q.x − c.x) − (a.x − c.x)·(q.y − c.y)) / D; β has the right signs.",
       [](const LessonSaid& s) {
         const Answer exact = oracle::answer(s.stage.one);
         const glm::dvec3 a = s.n.vector("a"), c = s.n.vector("c");
         const glm::dvec3 q = s.n.vector("o") + values_of(&exact).at(0) * s.n.vector("d");
         const double minus = (a.y - c.y) * (q.x - c.x), plus = (a.x - c.x) * (q.y - c.y);
         EXPECT_TRUE(is_close(s.n["λ₂"] * s.n["D"], -minus - plus, std::abs(minus) + std::abs(plus)));
         EXPECT_TRUE(is_close(s.n["β"] * s.n["D"], plus - minus, std::abs(minus) + std::abs(plus)));
       }},
      {"slab-intervals", "The ray is between them from t = x_in to t = x_out: an interval of the t axis.",
       [](const LessonSaid& s) { EXPECT_LE(s.n["x_in"], s.n["x_out"]); }},
      {"slab-intervals", "It enters at min.x where d.x > 0.",
       [](const LessonSaid& s) {
         EXPECT_GT(s.n["d.x"], 0);
         EXPECT_TRUE(is_close(s.n["o.x"] + s.n["x_in"] * s.n["d.x"], s.n["min.x"], 1));
       }},
      {"slab-intervals", "The same for y: the two intervals need not overlap.",
       [](const LessonSaid& s) {
         EXPECT_LE(s.n["y_in"], s.n["y_out"]);
         EXPECT_TRUE(is_close(s.n["o.y"] + s.n["y_in"] * s.n["d.y"], s.n["min.y"], 1));
       }},
      {"slab-intervals", "For an axis along which d is negative, the ray enters at max and leaves at min.",
       [](const LessonSaid& s) {
         EXPECT_LT(s.n["d.z"], 0);
         EXPECT_TRUE(is_close(s.n["o.z"] + s.n["z_in"] * s.n["d.z"], s.n["max.z"], 1));
         EXPECT_TRUE(is_close(s.n["o.z"] + s.n["z_out"] * s.n["d.z"], s.n["min.z"], 1));
       }}};
}

}  // namespace rayproof::viz
