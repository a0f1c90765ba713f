#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "unit/viz/walkthrough/captions/caption.hpp"
#include "viz/explain/case_report.hpp"

namespace rayproof::viz {
namespace {

/// Whether the ray runs along a face of a parallelepiped so nearly that doubles hardly show where it meets
/// it.
bool runs_along_a_face(const Case& one) {
  const auto& asked = std::get<RayQuestion>(one.question);
  const auto* solid = std::get_if<Parallelepiped<double>>(&asked.shape);
  if (solid == nullptr) return false;
  const glm::dmat3 to_object = asked.transform ? glm::inverse(glm::dmat3(*asked.transform)) : glm::dmat3(1);
  const glm::dvec3 d = to_object * asked.ray.direction;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &e = solid->edges[i], &f = solid->edges[(i + 1) % 3];
    const double size = glm::length(e) * glm::length(f) * glm::length(d);
    if (std::abs(glm::dot(glm::cross(e, f), d)) <= 1e-9 * size) return true;
  }
  return false;
}

bool is_any_zero(const glm::dvec3& v) { return v.x == 0 || v.y == 0 || v.z == 0; }

/// Entry and exit of every slab of a box by the numbers of the step before.
void expect_slabs(const Said& s) {
  if (!s.n.has_vector("min - o") || !s.n.has_vector("min")) return;
  const glm::dvec3 d = s.n.vector("d");
  if (is_any_zero(d)) return;
  const glm::dvec3 below = s.n.vector("min - o") / d, above = s.n.vector("max - o") / d;
  const glm::dvec3 first = glm::min(below, above), last = glm::max(below, above);
  const double entry = std::max({first.x, first.y, first.z}), exit = std::min({last.x, last.y, last.z});
  // Of two planes that rounding takes for equal, the exact numbers follow the one that was chosen.
  const double part = s.report.one.precision == Precision::float32 ? 1e7 : 10;
  EXPECT_TRUE(are_equal(s.n["t_exit"], exit, part * exit));
  EXPECT_TRUE(are_equal(s.n["t_entry"], entry, part * entry));
}

void expect_distances(const Said& s) {
  const glm::dvec3 o = s.n.has_vector("e₀") ? s.n.vector("o") : s.n.origin();
  const auto expect = [&](const char* name, const glm::dvec3& corner) {
    EXPECT_TRUE(are_equal(s.n.vector(name), corner - o, glm::length(corner) + glm::length(o))) << name;
  };
  const bool is_cube = !s.n.has_vector("min");
  expect("min - o", is_cube ? glm::dvec3(0) : s.n.input("min"));
  expect("max - o", is_cube ? glm::dvec3(1) : s.n.input("max"));
}

}  // namespace

std::vector<CheckedClaim> box_claims() {
  return {{"The six planes of the box lie at these signed distances from the ray's origin, along the axes.",
           expect_distances},
          // The numbers are put in by the walkthrough itself.
          {"Each pair of planes bounds a slab; the ray is in it between two t: (min - o) / d = # / # and "
           "(max - o) / d = # / #."},
          {"Each pair of planes bounds a slab; the ray is in it between two t: (min - o)·(1/d) = #·# and "
           "(max - o)·(1/d) = #·#."},
          {"Where d is negative along an axis, the ray enters at max; where it is 0, the ray is in that slab "
           "for all t or for none.",
           [](const Said& s) {
             const glm::dvec3 below = s.n.vector("min - o"), above = s.n.vector("max - o"),
                              d = s.n.vector("d");
             for (int i = 0; i < 3; ++i) {
               if (d[i] < 0) {
                 EXPECT_LE(above[i] / d[i], below[i] / d[i]);
               }
             }
           }},
          {"The ray is inside where all these intervals of t overlap: from the largest entry to the smallest "
           "exit.",
           [](const Said& s) {
             expect_slabs(s);
             // Which comes first is decided in floats, by numbers that may be equal but for their roundings.
             const auto hair = [&](const char* t) { return 1e-12 * std::abs(s.n[t]); };
             if (s.n.has("e₀") && std::isfinite(s.n["t_entry"])) {
               EXPECT_LE(s.n["e₀"], s.n["t_entry"] + hair("t_entry"));
             }
             if (s.n.has("e₁") && std::isfinite(s.n["t_exit"])) {
               EXPECT_GE(s.n["e₁"], s.n["t_exit"] - hair("t_exit"));
             }
           }},
          {"Where the exit comes first, it misses.",
           [](const Said& s) {
             const double entry = s.n["t_entry"], exit = s.n["t_exit"];
             if (runs_along_a_face(s.report.one)) return;
             if (exit < entry - 1e-12 * (std::abs(entry) + std::abs(exit))) {
               EXPECT_TRUE(values_of(&s.report.exact).empty()) << entry << " " << exit;
             }
           }},
          {"Each plane then costs a multiplication in place of a division."},
          {"Rounding may put the exit before the entry: two machine epsilons more, 2 to 4 ulps, can keep a "
           "ray that touches the box, and can make a hit of a near miss.",
           [](const Said& s) {
             EXPECT_FALSE(s.n.rounded("t_padded") < s.n.rounded("t_exit"));
             if (std::isnormal(s.n.rounded("t_exit")) && std::isfinite(s.n.rounded("t_padded"))) {
               EXPECT_GT(s.n.rounded("t_padded"), s.n.rounded("t_exit"));
             }
           }},
          {"1/d serves both planes of an axis; where a component of d is 0, it is infinite.",
           [](const Said& s) {
             const glm::dvec3 v = s.n.direction();
             const char* const axes[] = {"1/d.x", "1/d.y", "1/d.z"};
             for (int i = 0; i < 3; ++i) {
               if (v[i] == 0) {
                 EXPECT_TRUE(std::isinf(s.n.rounded(axes[i])));
               }
             }
           }},
          {"The two products with 1/d are put in order; a ray in a face has 0·∞ = NaN, and its hit is lost.",
           [](const Said& s) {
             const glm::dvec3 v = s.n.direction(), o = s.n.origin();
             const glm::dvec3 min = s.n.input("min"), max = s.n.input("max");
             bool is_in_face = false;
             for (int i = 0; i < 3; ++i)
               is_in_face = is_in_face || (v[i] == 0 && (o[i] == min[i] || o[i] == max[i]));
             if (is_in_face) {
               EXPECT_TRUE(values_of(s.report.claim()).empty());
             }
           }},
          {"A box counts as behind if t_exit < t_min; with NaN that comparison is false, as are "
           "<=, >, >= and =."}};
}

}  // namespace rayproof::viz
