#include <cmath>

#include "unit/viz/walkthrough/captions/caption.hpp"
#include "viz/explain/case_report.hpp"

namespace rayproof::viz {
namespace {

/// The plane's point by which a method measures: of a triangle a.
glm::dvec3 point_of_plane(const NumbersByName& n) {
  for (const char* name : {"p", "a", "v₀"})
    if (n.has_vector(name)) return n.input(name);
  return glm::dvec3(NAN);
}

double reach_of(const NumbersByName& n) { return glm::length(point_of_plane(n)) + glm::length(n.origin()); }

/// The ray as it was given, beside what the kernel has made of it in the object's space.
void expect_mapped_ray(const Said& s) {
  const glm::dvec3 x = s.n.input("A₁"), y = s.n.input("A₂"), z = s.n.input("A₃");
  const auto expect = [&](const char* mapped, const glm::dvec3& offset, const char* given) {
    const glm::dvec3 m = s.n.input(mapped);
    const double scale = std::abs(m.x) * glm::length(x) + std::abs(m.y) * glm::length(y) +
                         std::abs(m.z) * glm::length(z) + glm::length(offset);
    EXPECT_TRUE(are_equal(m.x * x + m.y * y + m.z * z + offset, s.n.input(given), scale)) << mapped;
  };
  expect("o′", s.n.input("T"), "o");
  expect("d", {}, "v");
}

void expect_no_hit_if_parallel(const Said& s, double progress) {
  if (progress == 0) {
    EXPECT_TRUE(values_of(&s.report.exact).empty());
  }
}

}  // namespace

std::vector<CheckedClaim> plane_claims() {
  return {
      {"The points q of the plane satisfy this equation; D follows from the given point.",
       [](const Said& s) {
         if (!s.n.has_vector("p") || !s.n.has_vector("n")) return;
         const glm::dvec3 n = s.n.vector("n"), p = s.n.vector("p");
         EXPECT_TRUE(are_equal(glm::dot(n, p), -s.n["D"], glm::length(n) * glm::length(p)));
       }},
      {"p(t) is in the plane where n·p(t) + D = 0."},
      {"n·o + D is the value at the ray's origin.",
       [](const Said& s) {
         const glm::dvec3 n = s.n.vector("n"), o = s.n.origin();
         const double size = glm::length(n) * glm::length(o) + std::abs(s.n["D"]);
         EXPECT_TRUE(are_equal(s.n["n·o + D"], glm::dot(n, o) + s.n["D"], size));
       }},
      {"Each unit of t adds n·d to n·p(t) + D.",
       [](const Said& s) {
         const glm::dvec3 n = s.n.vector("n"), d = s.n.direction();
         EXPECT_TRUE(are_equal(s.n["n·d"], glm::dot(n, d), glm::length(n) * glm::length(d)));
       }},
      {"t is minus the value at the ray's origin over what each unit of t adds; where that is 0, the ray is "
       "parallel to the plane or in it, and there is no t.",
       [](const Said& s) {
         expect_no_hit_if_parallel(s, s.n["n·d"]);
         if (s.n.has("n·o + D")) {
           EXPECT_TRUE(is_quotient(s.n["t"], -s.n["n·o + D"], s.n["n·d"]));
         }
       }},
      {"The inverse map applies to o and v; v is not normalised, so t is the same number in both spaces.",
       expect_mapped_ray},
      {"Of an implicit plane, p is the point nearest #; of a parametric plane, n is u × v.",
       [](const Said& s) {
         const glm::dvec3 n = s.n.vector("n"), p = s.n.vector("p");
         if (s.n.has_vector("u")) {
           const glm::dvec3 u = s.n.vector("u"), v = s.n.vector("v");
           EXPECT_TRUE(are_equal(n, glm::cross(u, v), glm::length(u) * glm::length(v)));
         } else if (s.n.has("D")) {
           const double size = glm::length(n) * glm::length(p);
           EXPECT_TRUE(are_equal(glm::cross(n, p), glm::dvec3(0), size));
           EXPECT_TRUE(are_equal(glm::dot(n, p), -s.n["D"], size));
         }
       }},
      {"p is a point of the plane: the vertex a of a triangle, v₀ of a polygon."},
      {"n·(p - o) is the signed distance from o to the plane, times |n|.",
       [](const Said& s) {
         const glm::dvec3 n = s.n.vector("n"), way = point_of_plane(s.n) - s.n.origin();
         EXPECT_TRUE(are_equal(s.n["n·(p - o)"], glm::dot(n, way), glm::length(n) * reach_of(s.n)));
       }},
      {"n·d is what the ray gains along n in each unit of t, times |n| too.",
       [](const Said& s) {
         const glm::dvec3 n = s.n.vector("n"), d = s.n.direction();
         EXPECT_TRUE(are_equal(s.n["n·d"], glm::dot(n, d), glm::length(n) * glm::length(d)));
       }},
      {"t is the quotient of the two; where the ray gains nothing, there is no single t.",
       [](const Said& s) {
         expect_no_hit_if_parallel(s, s.n["n·d"]);
         EXPECT_TRUE(is_quotient(s.n["t"], s.n["n·(p - o)"], s.n["n·d"]));
       }},
      {"α·u + β·v − t·d = w is three equations for α, β and t; w leads from the plane's point to the ray's "
       "origin.",
       [](const Said& s) {
         EXPECT_TRUE(are_equal(s.n.vector("w"), s.n.origin() - point_of_plane(s.n), reach_of(s.n)));
       }},
      {"D is the signed volume that u, v and d span: 0 where the ray is parallel to the plane.",
       [](const Said& s) {
         const glm::dvec3 u = s.n.vector("u"), v = s.n.vector("v"), d = s.n.direction();
         EXPECT_TRUE(are_equal(s.n["D"], glm::dot(glm::cross(u, v), d),
                               glm::length(u) * glm::length(v) * glm::length(d)));
         expect_no_hit_if_parallel(s, s.n["D"]);
       }},
      {"Cramer's rule: each unknown is a quotient of two volumes.",
       [](const Said& s) {  // α·u + β·v − t·d = w
         if (s.n["D"] == 0) return;
         const glm::dvec3 u = s.n.vector("u"), v = s.n.vector("v"), w = s.n.vector("w"), d = s.n.direction();
         const double t = s.n["t"], alpha = s.n["α"], beta = s.n["β"];
         const double scale = std::abs(alpha) * glm::length(u) + std::abs(beta) * glm::length(v) +
                              std::abs(t) * glm::length(d) + glm::length(w);
         EXPECT_TRUE(are_equal(alpha * u + beta * v - t * d, w, scale));
       }},
      {"The column d belongs to −t, so t = −D_t / D.",
       [](const Said& s) { EXPECT_TRUE(is_quotient(s.n["t"], -s.n["D_t"], s.n["D"])); }},
      {"u and v lie in the plane: they are perpendicular to its normal and to each other.",
       [](const Said& s) {
         const glm::dvec3 u = s.n.vector("u"), v = s.n.vector("v"), n = s.n.vector("n");
         EXPECT_TRUE(are_perpendicular(u, n));
         EXPECT_TRUE(are_perpendicular(v, n));
         EXPECT_TRUE(are_perpendicular(u, v));
       }},
      {"The coefficients of x₀, y₀ and z₀ are missing: the value at the ray's origin is n·o + D.",
       [](const Said& s) {
         const glm::dvec3 o = s.n.origin();
         const double printed = o.x + o.y + o.z + s.n["D"];
         EXPECT_TRUE(are_equal(s.n["x₀ + y₀ + z₀ + D"], printed, 3 * glm::length(o) + std::abs(s.n["D"])));
       }}};
}

}  // namespace rayproof::viz
