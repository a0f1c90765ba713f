#include <cmath>

#include "unit/viz/walkthrough/captions/lesson_caption.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/programs/report_of.hpp"

namespace rayproof::viz {
namespace {

/// How far a point that the stage shows is from the sphere, outwards, as it was rounded.
double height_of(const LessonSaid& s, const std::string& point) {
  Shadow square = 0;
  for (const std::string axis : {".x", ".y", ".z"}) {
    const Shadow part = Shadow(s.n.rounded(point + axis)) - Shadow(s.n.rounded("C" + axis));
    square += part * part;
  }
  return static_cast<double>(sqrt(square) - Shadow(s.n.rounded("r")));
}

bool is_near(double a, double b) { return std::abs(a - b) <= 0.01 * std::abs(b); }

/// "p is 2.1e-7 below the sphere": shown to three digits, of the point as it was rounded.
void expect_height(const LessonSaid& s, const std::string& point) {
  const std::string rest = s.sentence.substr(s.sentence.find(point + " is ") + point.size() + 4);
  const double height = height_of(s, point), said = numbers_in(rest).at(0);
  EXPECT_TRUE(is_near(std::abs(height), said)) << point << ": " << height;
  const std::size_t below = rest.find(" below"), above = rest.find(" above");
  EXPECT_EQ(height < 0, below < above) << point << ": " << height;
}

/// "The first triangle says: miss.", "Woop, the second says: hit.": of two triangles with one edge.
void expect_triangle(const LessonSaid& s) {
  Case one = s.stage.one;
  auto& triangle = std::get<Triangle<double>>(std::get<RayQuestion>(one.question).shape);
  if (s.sentence.find("second") != std::string::npos)
    triangle = {triangle.b, triangle.a, {2.5, static_cast<double>(1.8F), 1.5}};
  const char* const method = s.sentence.starts_with("Woop") ? "triangle/woop" : "triangle/moller_trumbore";
  const std::string verdict = verdict_of(report_of(one, method).claim());
  EXPECT_TRUE(s.sentence.ends_with("says: " + verdict + ".")) << verdict;
}

}  // namespace

std::vector<LessonClaim> solid_lesson_claims() {
  return {
      {"sphere", "r is the hypotenuse, |l| and half the chord are the legs.",
       [](const LessonSaid& s) {
         const glm::dvec3 l = s.n.vector("l");
         EXPECT_TRUE(are_equal(s.n["r"] * s.n["r"], glm::dot(l, l) + s.n["D"], s.n["r"] * s.n["r"]));
       }},
      {"sphere-half-b", "Here |d| = 1, so a = 1 and the division changes nothing.",
       [](const LessonSaid& s) {
         EXPECT_EQ(glm::length(s.n.vector("d")), 1);
         EXPECT_EQ(s.n["a"], 1);
       }},
      {"far-sphere",
       "Here b² is rounded to 6560707584 and 4ac to 6560708608: two ulps of 512 apart, and in the wrong "
       "order.",
       [](const LessonSaid& s) {
         const auto b = static_cast<float>(s.n.rounded("b")), a = static_cast<float>(s.n.rounded("a")),
                    c = static_cast<float>(s.n.rounded("c"));
         EXPECT_EQ(b * b, 6560707584.0F);
         EXPECT_EQ(4 * a * c, 6560708608.0F);
         EXPECT_EQ(std::nextafter(6560707584.0F, 7e9F) - 6560707584.0F, 512.0F);
         EXPECT_GT(s.n["D"], 0);
       }},
      {"conservative", "Here the exit comes first, computed as well as exactly.",
       [](const LessonSaid& s) {
         EXPECT_LT(s.n["t_exit"], s.n["t_entry"]);
         EXPECT_LT(s.n.rounded("t_exit"), s.n.rounded("t_entry"));
       }},
      {"conservative", "Exactly, t_entry = # and t_exit = #; computed, t_entry = # and t_padded = #.",
       [](const LessonSaid& s) {
         const std::vector<double> said = numbers_in(s.sentence);
         EXPECT_TRUE(said.at(0) > said.at(1) && said.at(2) <= said.at(3));
         EXPECT_TRUE(are_equal(said[0], s.n["t_entry"], 1) && are_equal(said[1], s.n["t_exit"], 1));
         EXPECT_EQ(static_cast<float>(said[2]), static_cast<float>(s.n.rounded("t_entry")));
         EXPECT_EQ(static_cast<float>(said[3]), static_cast<float>(s.n.rounded("t_padded")));
       }},
      {"leak", "* says: *.", expect_triangle},
      {"leak", "Both triangles have the same number W for it, with opposite signs: never do both miss there.",
       [](const LessonSaid& s) {
         const double before = numbers_up_to(s.stage, s.step - 1).rounded("W");
         EXPECT_EQ(s.n.rounded("W"), -before);
         EXPECT_NE(before, 0);
       }},
      {"leak",
       "Each triangle measures v, the distance from the edge as a share of its height: the first computes #, "
       "beyond it; the second computes #, beyond it.",
       [](const LessonSaid& s) {
         for (const double v : numbers_in(s.sentence)) EXPECT_LT(v, 0);
       }},
      {"leak", "So neither takes the ray.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(values_of(report_of(s.stage.one, "triangle/moller_trumbore").claim()).empty());
       }},
      {"leaving-a-sphere",
       "However good t is, the point is rounded in each coordinate: it lies beside the sphere.",
       [](const LessonSaid& s) { EXPECT_NE(height_of(s, "p"), 0); }},
      {"leaving-a-sphere",
       "The centre and r times a direction make a point of the sphere, whatever the direction's rounding: "
       "only "
       "the sphere's own numbers still count."},
      {"leaving-a-sphere",
       "In each component, the surface is within the error of the point, and the origin will be rounded once "
       "more."},
      {"leaving-a-sphere",
       "Only what lies along the normal can bring the origin to the wrong side; the normal itself is known "
       "to "
       "its tilt."},
      {"leaving-a-sphere", "A curved surface falls away from its tangent plane by the square of a distance."},
      {"leaving-a-sphere",
       "h is more than all roundings can take away, that of o′ among them: o′ lies on the side of n.",
       [](const LessonSaid& s) { EXPECT_GT(height_of(s, "o′"), 0); }},
      {"leaving-a-sphere", "Exactly, p is * the sphere, q is *, and o′ is *: the next ray starts outside.",
       [](const LessonSaid& s) {
         for (const char* point : {"p", "q", "o′"}) expect_height(s, point);
         EXPECT_GT(height_of(s, "o′"), 0);
       }},
      {"transformed", "M·q = A·q + T takes q = o′ + t₀·d = # to #, which is p(t₀).",
       [](const LessonSaid& s) {
         const std::vector<double> said = numbers_in(s.sentence.substr(s.sentence.find("t₀·d")));
         const RayQuestion& asked = std::get<RayQuestion>(s.stage.one.question);
         const glm::dvec3 q(said.at(0), said.at(1), said.at(2)), p(said.at(3), said.at(4), said.at(5));
         EXPECT_LT(glm::length(glm::dvec3(*asked.transform * glm::dvec4(q, 1)) - p), 1e-4);
         EXPECT_LT(glm::length(asked.ray.origin + s.n["t₀"] * asked.ray.direction - p), 1e-4);
       }},
      {"transformed", "Had d been normalised, t would be |d|·t₀ = # there, which is not the t of this ray.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(is_near(glm::length(s.n.vector("d")) * s.n["t₀"], numbers_in(s.sentence).at(0)));
       }}};
}

}  // namespace rayproof::viz
