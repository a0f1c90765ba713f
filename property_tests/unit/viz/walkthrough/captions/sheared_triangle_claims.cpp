#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "unit/viz/walkthrough/captions/caption.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// The axes as the kernel has renamed them: by how much, so that d is longest along z.
glm::dvec3 renamed(const NumbersByName& n, const glm::dvec3& v) {
  const glm::dvec3 given = n.direction(), d = n.vector("d");
  for (const int turn : {0, 1, 2}) {
    const auto turned = [&](const glm::dvec3& x) {
      return glm::dvec3(x[turn], x[(turn + 1) % 3], x[(turn + 2) % 3]);
    };
    if (turned(given) == d) return turned(v);
  }
  ADD_FAILURE() << "the axes are not renamed in turn";
  return v;
}

/// Of the corners as they were rounded.
void expect_sign(const Said& s, const char* side, const char* from, const char* to) {
  const auto at = [&](const char* corner, const char* axis) {
    return Shadow(s.n.rounded(std::string(corner) + axis));
  };
  const Shadow plus = at(from, ".x") * at(to, ".y"), minus = at(from, ".y") * at(to, ".x");
  const double rounded = s.n.rounded(side);
  if (!std::isfinite(rounded) || !isfinite(plus - minus) || abs(plus) < 1e-30 || abs(minus) < 1e-30) return;
  EXPECT_EQ(plus > minus, rounded > 0) << side;
  EXPECT_EQ(plus < minus, rounded < 0) << side;
}

}  // namespace

std::vector<CheckedClaim> sheared_triangle_claims() {
  return {
      {"The axes are renamed in turn, x, y, z as y, z, x or z, x, y, until d = # is longest along z.",
       [](const Said& s) {
         const glm::dvec3 d = s.n.vector("d");
         if (std::isnan(d.x + d.y + d.z)) return;
         EXPECT_GE(std::abs(d.z), std::max(std::abs(d.x), std::abs(d.y)));
         (void)renamed(s.n, d);
       }},
      {"The shear divides by d.z, so S_x and S_y are at most 1 in size.",
       [](const Said& s) {
         for (const std::string axis : {"x", "y"}) {
           EXPECT_FALSE(std::abs(s.n["S_" + axis]) > 1);
           EXPECT_FALSE(std::abs(s.n.rounded("S_" + axis)) > 1);
           EXPECT_TRUE(is_quotient(s.n["S_" + axis], s.n["d." + axis], s.n["d.z"]));
         }
       }},
      {"Each vertex has o subtracted, its axes renamed, and S_x·z and S_y·z taken from x and y.",
       [](const Said& s) {
         for (const char* vertex : {"a", "b", "c"}) {
           const glm::dvec3 from_o = renamed(s.n, s.n.input(vertex) - s.n.origin());
           const glm::dvec3 sheared = from_o - from_o.z * glm::dvec3(s.n["S_x"], s.n["S_y"], 0);
           EXPECT_TRUE(are_equal(s.n.vector(vertex), sheared,
                                 2 * (glm::length(s.n.input(vertex)) + glm::length(s.n.origin()))));
         }
       }},
      {"Now the ray is the z axis; seen along it, it is the point #."},
      {"The sign of U, V and W is exact where no product underflows: it says on which side of an edge # "
       "lies.",
       [](const Said& s) {
         expect_sign(s, "U", "c", "b");
         expect_sign(s, "V", "a", "c");
         expect_sign(s, "W", "b", "a");
       }},
      {"The ray hits where no two of them have opposite signs and D is not 0.",
       [](const Said& s) {
         const std::array<double, 3> sides{s.n["U"], s.n["V"], s.n["W"]};
         const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
         const double size = std::max(std::abs(*least), std::abs(*most));
         if (*least<-1e-9 * size&& * most> 1e-9 * size) {
           EXPECT_TRUE(values_of(&s.report.exact).empty());
         }
       }},
      {"U, V and W over their sum D are the weights of the vertices; the hit's depth z is the weighted mean, "
       "and t = z / d.z.",
       [](const Said& s) {
         const double U = s.n["U"], V = s.n["V"], W = s.n["W"], D = s.n["D"];
         const double a = s.n["a.z"], b = s.n["b.z"], c = s.n["c.z"];
         const double size = std::abs(U) + std::abs(V) + std::abs(W);
         EXPECT_TRUE(are_equal(D, U + V + W, size));
         EXPECT_TRUE(are_equal(s.n["z"] * D, U * a + V * b + W * c,
                               size * std::max({std::abs(a), std::abs(b), std::abs(c)})));
         EXPECT_TRUE(is_quotient(s.n["t"], s.n["z"], s.n["d.z"]));
         expect_hit(s.report, std::min({U / D, V / D, W / D}), s.n["t"]);
       }}};
}

}  // namespace rayproof::viz
