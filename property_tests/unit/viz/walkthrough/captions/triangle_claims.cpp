#include <algorithm>
#include <cmath>

#include "unit/viz/walkthrough/captions/caption.hpp"

namespace rayproof::viz {
namespace {

void expect_edge(const Said& s, const char* name, const char* to) {
  const double size = glm::length(s.n.input("a")) + glm::length(s.n.input(to));
  EXPECT_TRUE(are_equal(s.n.vector(name), edge_to(s.n, to), size)) << name;
}

double triple_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::length(a) * glm::length(b) * glm::length(c);
}

glm::dvec3 normal_of_edges(const NumbersByName& n) { return glm::cross(edge_to(n, "b"), edge_to(n, "c")); }

}  // namespace

std::vector<CheckedClaim> triangle_claims() {
  return {
      {"u leads from a to b.", [](const Said& s) { expect_edge(s, "u", "b"); }},
      {"v leads from a to c: a + α·u + β·v is a point of the plane for every α and β.",
       [](const Said& s) { expect_edge(s, "v", "c"); }},
      {"e₁ leads from a to b.", [](const Said& s) { expect_edge(s, "e₁", "b"); }},
      {"e₂ leads from a to c.", [](const Said& s) { expect_edge(s, "e₂", "c"); }},
      {"It does where D is not 0, both parameters are at least 0 and their sum is at most 1.",
       [](const Said& s) {
         const bool is_cramer = s.n.has("α");
         const double u = s.n[is_cramer ? "α" : "u"], v = s.n[is_cramer ? "β" : "v"];
         if (s.n["D"] != 0) expect_hit(s.report, std::min({u, v, 1 - u - v}), s.n["t"]);
       }},
      {"n is perpendicular to both edges, and its length is twice the area.",
       [](const Said& s) {
         const glm::dvec3 n = s.n.vector("n"), b = edge_to(s.n, "b"), c = edge_to(s.n, "c");
         EXPECT_TRUE(are_perpendicular(n, b, 1e-13));
         EXPECT_TRUE(are_perpendicular(n, c, 1e-13));
         const double size =
             glm::length(s.n.input("a")) + glm::length(s.n.input("b")) + glm::length(s.n.input("c"));
         EXPECT_TRUE(are_equal(glm::length(n), glm::length(normal_of_edges(s.n)), size * size));
       }},
      {"The coordinate in which n = # is largest is left out: this projection keeps the most area."},
      {"Each is the area of the triangle that q makes with the side opposite its vertex, over the whole "
       "area; q is inside where none is negative.",
       [](const Said& s) {
         const glm::dvec3 n = s.n.vector("n");
         const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
         const double alpha = s.n["α"], beta = s.n["β"], gamma = s.n["γ"], size = glm::length(s.n.input("a"));
         EXPECT_TRUE(are_equal(std::abs(s.n["D"]), most, most + size * size));
         EXPECT_TRUE(are_equal(alpha + beta + gamma, 1, std::abs(alpha) + std::abs(beta) + 1));
         expect_hit(s.report, std::min({alpha, beta, gamma}), s.n["t"]);
       }},
      {"p = d × e₂ is perpendicular to the ray and to e₂.",
       [](const Said& s) {
         EXPECT_TRUE(are_perpendicular(s.n.vector("p"), s.n.direction()));
         EXPECT_TRUE(are_perpendicular(s.n.vector("p"), s.n.vector("e₂")));
       }},
      {"D = e₁·(d × e₂) is the volume that e₁, d and e₂ span: 0 where the ray is parallel to the triangle.",
       [](const Said& s) {
         const glm::dvec3 a = s.n.vector("e₁"), b = s.n.vector("e₂"), d = s.n.direction();
         EXPECT_TRUE(are_equal(s.n["D"], glm::dot(a, glm::cross(d, b)), triple_size(a, b, d)));
       }},
      {"u is a quotient of two volumes: D with s in the place of e₁, over D: u = s·(d × e₂) / D.",
       [](const Said& s) {
         const glm::dvec3 from = s.n.vector("s"), b = s.n.vector("e₂"), d = s.n.direction();
         EXPECT_TRUE(
             are_equal(s.n["u"] * s.n["D"], glm::dot(from, glm::cross(d, b)), triple_size(from, b, d)));
       }},
      {"q is perpendicular to s and e₁.",
       [](const Said& s) {
         EXPECT_TRUE(are_perpendicular(s.n.vector("q"), s.n.vector("s")));
         EXPECT_TRUE(are_perpendicular(s.n.vector("q"), s.n.vector("e₁")));
       }},
      {"v = d·(s × e₁) / D and t = e₂·(s × e₁) / D are quotients of volumes.",
       [](const Said& s) {
         const glm::dvec3 from = s.n.vector("s"), a = s.n.vector("e₁"), b = s.n.vector("e₂"),
                          d = s.n.direction(), q = glm::cross(from, a);
         EXPECT_TRUE(are_equal(s.n["v"] * s.n["D"], glm::dot(d, q), triple_size(from, a, d)));
         EXPECT_TRUE(are_equal(s.n["t"] * s.n["D"], glm::dot(b, q), triple_size(from, a, b)));
       }},
      {"Seen from its origin the ray is only its direction d, so each edge needs only d and its two ends.",
       [](const Said& s) {
         const double size = glm::length(s.n.input("a")) + glm::length(s.n.origin());
         EXPECT_TRUE(are_equal(s.n.vector("a"), s.n.input("a") - s.n.origin(), size));
       }},
      {"U, V and W are twice the volumes that d and the two ends of an edge span; the ray hits where no two "
       "have opposite signs and their sum is not 0.",
       [](const Said& s) {
         const auto expect = [&](const char* side, const char* p, const char* q) {
           const glm::dvec3 from = s.n.vector(p), to = s.n.vector(q), d = s.n.direction();
           EXPECT_TRUE(
               are_equal(s.n[side], 2 * glm::dot(d, glm::cross(from, to)), 2 * triple_size(from, to, d)));
         };
         expect("U", "b", "c");
         expect("V", "c", "a");
         expect("W", "a", "b");
       }},
      {"t is n·a, |n| times the distance to the plane, over the progress n·d; U, V and W over their sum are "
       "the barycentric coordinates.",
       [](const Said& s) {
         const double U = s.n["U"], V = s.n["V"], W = s.n["W"], sum = s.n["U+V+W"];
         EXPECT_TRUE(are_equal(sum, U + V + W, std::abs(U) + std::abs(V) + std::abs(W)));
         EXPECT_TRUE(is_quotient(s.n["u"], V, sum));
         EXPECT_TRUE(is_quotient(s.n["v"], W, sum));
         const glm::dvec3 n = s.n.vector("n"), a = s.n.vector("a");
         EXPECT_TRUE(are_equal(s.n["t"] * s.n["n·d"], glm::dot(n, a), glm::length(n) * glm::length(a)));
         expect_hit(s.report, std::min({U / sum, V / sum, W / sum}), s.n["t"]);
       }},
      {"These are the points of a whole parallelogram: the condition α + β ≤ 1 is missing."},
      {"The second sign in the numerator of λ₂ is wrong: it must be +."},
      {"z is ignored, and a triangle perpendicular to the xy plane has no area in x and y.",
       [](const Said& s) {
         const double size =
             glm::length(s.n.input("a")) + glm::length(s.n.input("b")) + glm::length(s.n.input("c"));
         EXPECT_TRUE(are_equal(std::abs(s.n["D"]), std::abs(normal_of_edges(s.n).z), size * size));
       }}};
}

}  // namespace rayproof::viz
