#include <cmath>

#include "unit/viz/walkthrough/captions/lesson_caption.hpp"

namespace rayproof::viz {
namespace {

/// Of the torus with circles of radius 1.25 and 0.5, where its value is 0.
double torus_value(const glm::dvec3& p) {
  const double k = glm::dot(p, p) - 1.25 * 1.25 - 0.5 * 0.5;
  return k * k + 4 * 1.25 * 1.25 * (p.z * p.z - 0.5 * 0.5);
}

/// The point that the value of the step's title was computed at.
glm::dvec3 latest_point(const LessonSaid& s) { return s.n.vector(s.n.has_vector("p_b") ? "p_b" : "p_a"); }

/// The tangents of the unit sphere at q, in the world.
std::vector<glm::dvec3> tangents(const LessonSaid& s) {
  const glm::dvec3 n = s.n.vector("n"), x = s.n.vector("A₁"), y = s.n.vector("A₂"), z = s.n.vector("A₃");
  std::vector<glm::dvec3> all;
  for (const glm::dvec3& u : {glm::cross(n, glm::dvec3(1, 0, 0)), glm::cross(n, glm::dvec3(0, 1, 0))})
    all.push_back(u.x * x + u.y * y + u.z * z);
  return all;
}

double cosine(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::dot(glm::normalize(a), glm::normalize(b));
}

}  // namespace

std::vector<LessonClaim> surface_lesson_claims() {
  return {
      {"transformed-normal",
       "The inverse map applies to the ray; q is the point of the mapped ray at the same t.",
       [](const LessonSaid& s) {
         const RayQuestion& asked = std::get<RayQuestion>(s.stage.one.question);
         const glm::dvec3 p(*asked.transform * glm::dvec4(s.n.vector("q"), 1));
         EXPECT_LT(glm::length(glm::cross(p - asked.ray.origin, asked.ray.direction)), 1e-5);
       }},
      {"transformed-normal", "The sphere's radius ends at q and is perpendicular to the surface.",
       [](const LessonSaid& s) { EXPECT_NEAR(glm::length(s.n.vector("q")), 1, 1e-5); }},
      {"transformed-normal",
       "A maps tangents to tangents, but does not preserve the right angle between them and the normal.",
       [](const LessonSaid& s) {
         const auto all = tangents(s);
         EXPECT_GT(std::abs(cosine(s.n.vector("A·n"), all[0])) + std::abs(cosine(s.n.vector("A·n"), all[1])),
                   0.01);
       }},
      {"transformed-normal",
       "m = A⁻ᵀ·n: its product with A·u is n·u, which is 0 for every tangent u, so m is perpendicular to the "
       "surface.",
       [](const LessonSaid& s) {
         for (const glm::dvec3& tangent : tangents(s))
           EXPECT_LT(std::abs(cosine(s.n.vector("m"), tangent)), 1e-5);
       }},
      {"transformed-normal", "A·u is the tangent in the world."},
      {"implicit-torus",
       "f at a point of the ray: its sign says on which side of the surface the point lies.",
       [](const LessonSaid& s) {
         const bool is_inside = s.stage.steps[s.step].title.find("f < 0") != std::string::npos;
         EXPECT_EQ(torus_value(latest_point(s)) < 0, is_inside);
       }},
      {"implicit-torus",
       "k is the squared distance from the centre less R² + r²: 0 on the highest and lowest circle of the "
       "torus.",
       [](const LessonSaid& s) {
         const glm::dvec3 p = latest_point(s);
         EXPECT_TRUE(are_equal(s.n["k"], glm::dot(p, p) - 1.8125, glm::dot(p, p)));
       }},
      {"implicit-torus",
       "The second term is 0 at the heights ±r and negative between them, so that f is 0 on the whole torus.",
       [](const LessonSaid& s) {
         for (const double around : {0.0, 0.7, 1.9, 3.0}) {
           const glm::dvec3 p(1.25 + 0.5 * std::cos(around), 0, 0.5 * std::sin(around));
           EXPECT_NEAR(torus_value(p), 0, 1e-12);
         }
         EXPECT_LT(std::abs(latest_point(s).z), 0.5);
       }},
      {"implicit-torus",
       "f is continuous, so between both there is a root: t_s is where the straight line between them is 0.",
       [](const LessonSaid& s) {
         const double a = s.n["f(t_a)"], b = s.n["f(t_b)"];
         EXPECT_LT(a * b, 0);
         EXPECT_TRUE(are_equal(s.n["t_s"], 1 + 0.5 * a / (a - b), 1));
       }},
      {"implicit-torus",
       "Interval arithmetic says where f cannot be 0, and Newton steps shrink the rest: # roots.",
       [](const LessonSaid& s) { EXPECT_EQ(numbers_in(s.sentence).at(1), 4); }},
      {"implicit-torus", "t* in [#].",
       [](const LessonSaid& s) {
         const Ray<double>& ray = std::get<RayQuestion>(s.stage.one.question).ray;
         const std::vector<double> ends = numbers_in(s.sentence);
         const auto f = [&](double t) { return torus_value(ray.origin + t * ray.direction); };
         EXPECT_LT(f(ends.at(0)) * f(ends.at(1)), 0);
       }},
      {"parametric-patch",
       "p is the corner r(0, 0) seen from the ray's origin, p_u and e lead to the next corners along u and "
       "v, and e_u is what e gains along u.",
       [](const LessonSaid& s) {
         EXPECT_LT(glm::length(s.n.vector("p") - (glm::dvec3(-1.25, -1, 0.75) - s.n.vector("o"))), 1e-6);
       }},
      {"parametric-patch",
       "For each u the patch has a straight line, its ruling; it meets the ray where both lie in one plane, "
       "a quadratic equation in u."},
      {"parametric-patch",
       "The two lines meet where p(u) + v·e(u) = t·d; products with their normal n = d × e(u) give t and v.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(are_perpendicular(s.n.vector("n"), s.n.vector("e(u)"), 1e-6));
         EXPECT_TRUE(are_perpendicular(s.n.vector("n"), s.n.vector("p(u)"), 1e-6));  // all three in one plane
       }},
      {"parametric-patch", "p(u) × e(u) along n is t times n·n, and p(u) × d along n is v times n·n.",
       [](const LessonSaid& s) {
         const glm::dvec3 n = s.n.vector("n"), p = s.n.vector("p(u)"), e = s.n.vector("e(u)"),
                          d = s.n.vector("d");
         // Of the second ruling p(u) and e(u) are not shown.
         if (glm::length(glm::cross(p, e) - s.n.vector("g")) > 1e-5) return;
         EXPECT_NEAR(glm::dot(glm::cross(p, e), n), s.n["t"] * glm::dot(n, n), 1e-5);
         EXPECT_NEAR(glm::dot(glm::cross(p, d), n), s.n["v"] * glm::dot(n, n), 1e-5);
       }},
      {"parametric-patch", "Where u or v is not in [0, 1], the lines meet off the patch.",
       [](const LessonSaid& s) {  // here behind the origin, where the patch is not
         EXPECT_EQ(s.n["v"] >= 0 && s.n["v"] <= 1, s.n["t"] > 0);
       }}};
}

}  // namespace rayproof::viz
