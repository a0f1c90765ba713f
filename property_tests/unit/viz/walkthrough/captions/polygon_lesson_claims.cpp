#include <algorithm>
#include <cmath>

#include "unit/viz/walkthrough/captions/lesson_caption.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// Of the step's side: s and t as they were computed.
struct MetSide {
  double s, t;
};
MetSide crossing(const LessonSaid& said) {
  const auto& values = said.stage.steps[said.step].values;
  return {values.at(0).components[0].value, values.at(1).components[0].value};
}

const PointAndPolygon<double>& asked(const LessonSaid& said) {
  return std::get<PointAndPolygon<double>>(said.stage.one.question);
}

/// The side of the step after the first: from its first vertex to its second.
std::pair<Vec2<double>, Vec2<double>> side_of(const LessonSaid& said) {
  const auto& v = asked(said).vertices;
  return {v.at(said.step - 1), v.at(said.step % v.size())};
}

/// How many steps up to this one say that their side counts.
int counted_up_to(const LessonSaid& said) {
  int count = 0;
  for (std::size_t i = 0; i <= said.step; ++i)
    count += said.stage.steps[i].words.find("it counts.") != std::string::npos ? 1 : 0;
  return count;
}

void expect_count(const LessonSaid& said) { EXPECT_EQ(numbers_in(said.sentence).at(0), counted_up_to(said)); }

/// By the exact rule: below the point's height or on it, and above.
bool passes_height(const LessonSaid& said) {
  const auto [a, b] = side_of(said);
  return (a.y <= asked(said).point.y) != (b.y <= asked(said).point.y);
}

}  // namespace

std::vector<LessonClaim> polygon_lesson_claims() {
  return {
      {"", "0 ≤ s* ≤ 1 and t* > 0: it counts.",
       [](const LessonSaid& said) {
         const auto [s, t] = crossing(said);
         EXPECT_TRUE(s >= 0 && s <= 1 && t > 0) << s << " " << t;
       }},
      {"", "t* < 0, behind p: it does not count.",
       [](const LessonSaid& said) { EXPECT_LT(crossing(said).t, 0); }},
      {"", "t* = 0, at p: it does not count.",
       [](const LessonSaid& said) { EXPECT_EQ(crossing(said).t, 0); }},
      {"", "One end lies below the ray and one above, and t* > 0: it counts.",
       [](const LessonSaid& said) {
         const auto [a, b] = side_of(said);
         const double y = asked(said).point.y;
         EXPECT_TRUE(std::min(a.y, b.y) < y && y < std::max(a.y, b.y));
         EXPECT_GT(crossing(said).t, 0);
       }},
      {"", "v* is its lower end and lies on the ray: included.",
       [](const LessonSaid& said) {
         const auto [a, b] = side_of(said);
         EXPECT_EQ(std::min(a.y, b.y), asked(said).point.y);
         EXPECT_NE(a.y, b.y);
       }},
      {"", "t* > 0: it counts.", [](const LessonSaid& said) { EXPECT_GT(crossing(said).t, 0); }},
      {"", "s* > 1, beyond the side: it does not count.",
       [](const LessonSaid& said) { EXPECT_GT(crossing(said).s, 1); }},
      {"", "s* < 0, before the side: it does not count.",
       [](const LessonSaid& said) { EXPECT_LT(crossing(said).s, 0); }},
      {"", "s* is NaN, which fails every ordered comparison: the side counts 0.",
       [](const LessonSaid& said) { EXPECT_TRUE(std::isnan(crossing(said).s)); }},
      {"", "It is met at its start v*.", [](const LessonSaid& said) { EXPECT_EQ(crossing(said).s, 0); }},
      {"", "It is met at its end v*.", [](const LessonSaid& said) { EXPECT_EQ(crossing(said).s, 1); }},
      {"", "Crossings so far: #.", expect_count},
      {"",
       "The ray meets the line through the side at t; s is the place on the line, 0 to 1 from end to end."},
      {"", "v* lies at y = #, * the ray at y = #: no crossing.",
       [](const LessonSaid& said) {
         const auto [a, b] = side_of(said);
         EXPECT_TRUE(a.y == b.y && a.y != asked(said).point.y);
       }},
      {"", "v* runs from y = # to #, * the ray at y = #: no crossing.",
       [](const LessonSaid& said) {
         const auto [a, b] = side_of(said);
         const double y = asked(said).point.y;
         const bool is_below = said.sentence.find("below the ray") != std::string::npos;
         EXPECT_TRUE(is_below ? std::max(a.y, b.y) < y : std::min(a.y, b.y) > y || std::min(a.y, b.y) == y);
         EXPECT_FALSE(passes_height(said));
       }},
      {"", "v* runs from y = # to #."},
      {"", "Its upper end v* lies on the ray and is excluded: a side contains only its lower end.",
       [](const LessonSaid& said) {
         const auto [a, b] = side_of(said);
         EXPECT_EQ(std::max(a.y, b.y), asked(said).point.y);
         EXPECT_NE(a.y, b.y);
       }},
      {"", "v* lies along the ray at y = # and has no lower end: no crossing.",
       [](const LessonSaid& said) {
         const auto [a, b] = side_of(said);
         EXPECT_TRUE(a.y == b.y && a.y == asked(said).point.y);
       }},
      {"", "* crossing is an odd number: the point is inside.", expect_count},
      {"", "* crossings are an odd number: the point is inside.", expect_count},
      {"", "* crossings are an even number: the point is outside.", expect_count},
      {"", "In exact arithmetic it is *.",
       [](const LessonSaid& said) {
         EXPECT_TRUE(said.sentence.ends_with("side.") || said.sentence.ends_with("boundary."));
       }},
      {"polygon-vertex-trap",
       "v₂ is an end of two closed sides, and both count it: the rule is at fault, not rounding.",
       [](const LessonSaid& said) { EXPECT_EQ(asked(said).vertices.at(2).y, asked(said).point.y); }},
      {"polygon-horizontal-trap",
       "NaN fails every ordered comparison: v₂v₃ counts 0; the closed sides v₁v₂ and v₃v₄ count an end each.",
       [](const LessonSaid& said) {
         EXPECT_EQ(asked(said).vertices.at(2).y, asked(said).vertices.at(3).y);
         EXPECT_EQ(counted_up_to(said), 2);
       }},
      {"polygon-in-space",
       "n is the sum of the cross products of neighbouring vertices: perpendicular to the polygon, twice its "
       "area long.",
       [](const LessonSaid& said) {
         const auto& v =
             std::get<Polygon<double>>(std::get<RayQuestion>(said.stage.one.question).shape).vertices;
         glm::dvec3 sum(0);
         for (std::size_t i = 0; i < v.size(); ++i) sum += glm::cross(v[i], v[(i + 1) % v.size()]);
         EXPECT_LT(glm::length(sum - said.n.vector("n")), 1e-6);
         for (std::size_t i = 0; i < v.size(); ++i)
           EXPECT_LT(std::abs(glm::dot(sum, v[(i + 1) % v.size()] - v[i])), 1e-6);
       }},
      {"polygon-in-space",
       "s is the place on the side and t that on the ray: an odd number of crossings with t > 0 means "
       "inside."},
      {"ray-segment", "0 ≤ s₀ ≤ 1 and t₀ > 0: a hit.",
       [](const LessonSaid& said) {
         EXPECT_TRUE(said.n["s₀"] >= 0 && said.n["s₀"] <= 1 && said.n["t₀"] > 0);
       }},
      {"ray-segment", "s is the place on the segment, 0 at v₀ and 1 at v₁; t is that on the ray."},
      {"ray-segment", "s₁ > 1: the line of the segment is met beyond v₁.",
       [](const LessonSaid& said) { EXPECT_GT(said.n["s₁"], 1); }},
      {"ray-segment", "t₂ < 0: the segment lies behind the ray's origin.",
       [](const LessonSaid& said) { EXPECT_LT(said.n["t₂"], 0); }}};
}

}  // namespace rayproof::viz
