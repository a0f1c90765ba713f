#include <cmath>

#include "unit/viz/walkthrough/captions/caption.hpp"

namespace rayproof::viz {
namespace {

/// The ray's quadratic in t, as the exact numbers of f, d and r make it.
struct OfSphere {
  double a, half_b, c, scale_c;
  glm::dvec3 f, d;
  double r;
};

OfSphere of(const Said& s) {
  const glm::dvec3 f = s.n.origin() - s.n.input("C");
  const glm::dvec3 d = s.n.has_vector("d̂") ? s.n.vector("d̂") : s.n.direction();
  const double r = s.n["r"];
  return {glm::dot(d, d), glm::dot(d, f), glm::dot(f, f) - r * r, glm::dot(f, f) + r * r, f, d, r};
}

/// The numbers were given before they were rounded to double here: what cancels in f is known less well.
double far_size(const Said& s) { return glm::length(s.n.origin()) + glm::length(s.n.input("C")); }

void expect_coefficients(const Said& s, double a, double b) {
  const OfSphere q = of(s);
  const double far = std::pow(far_size(s), 2);
  if (s.n.has("a")) {
    EXPECT_TRUE(are_equal(s.n["a"], a, a));
  }
  EXPECT_TRUE(are_equal(s.n["c"], q.c, q.scale_c + far));
  if (s.n.has("b")) {
    EXPECT_TRUE(are_equal(std::abs(s.n["b"]), std::abs(b), std::abs(b) + far_size(s) * glm::length(q.d)));
  }
}

void expect_square_of_half_chord(const Said& s) {
  const OfSphere q = of(s);
  const double l = glm::length(s.n.vector("l")), scale = q.r * q.r + l * l;
  EXPECT_TRUE(are_equal(s.n["D"], q.r * q.r - l * l, scale));
  if (std::abs(l - q.r) > 1e-13 * (l + q.r)) {
    EXPECT_EQ(s.n["D"] > 0, l < q.r);
  }
}

}  // namespace

std::vector<CheckedClaim> sphere_claims() {
  return {
      {"|o + t·d − C|² = r² is a quadratic equation in t.",
       [](const Said& s) {
         const OfSphere q = of(s);
         const bool is_halved = s.report.method == "sphere/half_b" || s.report.method == "sphere/stable";
         expect_coefficients(s, q.a, is_halved ? q.half_b : 2 * q.half_b);
       }},
      {"With ±2b as the linear coefficient, b² − a·c is a quarter of the discriminant and has its sign.",
       [](const Said& s) {
         const OfSphere q = of(s);
         const double scale = q.half_b * q.half_b + q.a * (q.scale_c + std::pow(far_size(s), 2));
         EXPECT_TRUE(are_equal(4 * s.n["D"], std::pow(2 * q.half_b, 2) - 4 * q.a * q.c, 4 * scale));
       }},
      {"With 2b as the linear coefficient every factor 2 cancels: t = (−b ± √D) / a.",
       [](const Said& s) {
         if (!(s.n["D"] >= 0)) return;
         const double b = s.n["b"], root = s.n["√D"], scale = std::abs(b) + root;
         EXPECT_TRUE(are_equal(s.n["t₀"] * s.n["a"], -b - root, scale));
         EXPECT_TRUE(are_equal(s.n["t₁"] * s.n["a"], -b + root, scale));
       }},
      {"f points from the centre to o; the sphere's position enters only through it.",
       [](const Said& s) { EXPECT_TRUE(are_equal(s.n.vector("f"), of(s).f, far_size(s))); }},
      {"t_c is where the ray comes nearest the centre.",
       [](const Said& s) {
         const OfSphere q = of(s);
         EXPECT_TRUE(are_equal(s.n["t_c"] * q.a, -q.half_b, far_size(s) * glm::length(q.d)));
       }},
      {"l leads from the centre to that point: it is perpendicular to d, and |l| is the distance of the line "
       "from the centre.",
       [](const Said& s) {
         const OfSphere q = of(s);
         const glm::dvec3 l = s.n.vector("l");
         const double d = glm::length(q.d);
         EXPECT_TRUE(are_perpendicular(l, q.d, 1e-13));
         EXPECT_TRUE(are_equal(glm::length(l) * d, glm::length(glm::cross(q.f, q.d)), far_size(s) * d));
       }},
      {"Where the line passes within the radius, D is positive: by Pythagoras the square of half the chord.",
       [](const Said& s) {
         if (s.n.has("r")) expect_square_of_half_chord(s);
       }},
      {"b² − 4ac of the quadratic formula is 4a·D.",
       [](const Said& s) {
         if (!s.n.has("r")) return;  // of a cylinder: see cylinder_claims
         const OfSphere q = of(s);
         const double scale = q.half_b * q.half_b + q.a * (q.scale_c + std::pow(far_size(s), 2));
         EXPECT_TRUE(are_equal(4 * q.a * s.n["D"], 4 * (q.half_b * q.half_b - q.a * q.c), 4 * scale));
       }},
      {"The denominator must be 2a: the printed 2ac gives wrong roots unless c = 1.",
       [](const Said& s) {
         const double a = s.n["a"], b = s.n["b"], c = s.n["c"], root = s.n["√D"];
         if (!std::isfinite(root) || c == 0) return;
         EXPECT_TRUE(are_equal(s.n["t₀"] * c * 2 * a, -b - root, std::abs(b) + root));
         EXPECT_TRUE(are_equal(s.n["t₁"] * c * 2 * a, -b + root, std::abs(b) + root));
       }},
      {"|o + t·d − C|² = r² is t² + 2b·t + c = 0 only where a = |d|² is 1.",
       [](const Said& s) { expect_coefficients(s, of(s).a, of(s).half_b); }},
      {"b² − c is a quarter of the discriminant only where a = 1.",
       [](const Said& s) {
         const double b = s.n["b"], c = s.n["c"];
         EXPECT_TRUE(are_equal(s.n["D"], b * b - c, b * b + std::abs(c)));
       }},
      {"The division by a = |d|² is missing.",
       [](const Said& s) {
         const double b = s.n["b"], root = s.n["√D"];
         EXPECT_TRUE(are_equal(s.n["t₀"], -b - root, std::abs(b) + root));
         EXPECT_TRUE(are_equal(s.n["t₁"], -b + root, std::abs(b) + root));
       }},
      {"From here on t is a length in the object's space, |d| times the t of the given ray: that is the "
       "printed "
       "error.",
       [](const Said& s) {
         const double length = glm::length(s.n.direction());
         EXPECT_TRUE(are_equal(s.n["|d|"], length, length));
         EXPECT_TRUE(are_equal(s.n.vector("d̂") * s.n["|d|"], s.n.direction(), length));
       }}};
}

}  // namespace rayproof::viz
