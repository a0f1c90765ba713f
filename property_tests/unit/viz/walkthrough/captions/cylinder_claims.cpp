#include <algorithm>
#include <cmath>

#include "unit/viz/walkthrough/captions/caption.hpp"
#include "viz/explain/case_report.hpp"

namespace rayproof::viz {
namespace {

/// In the plane in which the side is the unit circle.
glm::dvec3 scaled(const NumbersByName& n, const glm::dvec3& v) { return {v.x / n["rx"], v.y / n["ry"], 0}; }
glm::dvec3 scaled_origin(const Said& s) { return scaled(s.n, s.n.origin()); }
glm::dvec3 scaled_direction(const Said& s) { return scaled(s.n, s.n.direction()); }

glm::dvec3 in_plane(const NumbersByName& n, const char* name) {
  const glm::dvec3 v = n.vector(name);
  return {v.x, v.y, 0};
}

/// A root of the endless side is a hit exactly where it lies between both ends and in the ray's interval.
void expect_root(const Said& s, double root) {
  const Ray<double>& ray = std::get<RayQuestion>(s.report.one.question).ray;
  const double from = std::max(s.n["e₀"], ray.t_min), to = std::min(s.n["e₁"], ray.t_max);
  const double near = 1e-5 * std::abs(root);
  const bool is_clear = std::isfinite(root) && std::abs(root - from) > near && std::abs(root - to) > near;
  if (!is_clear || std::isnan(from) || std::isnan(to)) return;
  const std::vector<double> hits = values_of(&s.report.exact);
  const bool is_hit =
      std::any_of(hits.begin(), hits.end(), [&](double t) { return std::abs(t - root) <= near; });
  EXPECT_EQ(is_hit, from < root && root < to) << root << " between " << from << " and " << to;
}

void expect_on_circle(const Said& s, double t) {
  const glm::dvec3 f = scaled_origin(s), d = scaled_direction(s), p = f + t * d;
  const double scale = std::pow(glm::length(f) + std::abs(t) * glm::length(d), 2);
  EXPECT_TRUE(are_equal(glm::dot(p, p), 1, scale));
}

}  // namespace

std::vector<CheckedClaim> cylinder_claims() {
  return {{"Dividing x by rx and y by ry turns the side into the circle x² + y² = 1 and leaves t as it is.",
           [](const Said& s) {
             const glm::dvec3 f = scaled_origin(s), d = scaled_direction(s);
             EXPECT_TRUE(are_equal(in_plane(s.n, "f"), f, glm::length(f)));
             EXPECT_TRUE(are_equal(in_plane(s.n, "d"), d, glm::length(d)));
           }},
          {"(f.x + t·d.x)² + (f.y + t·d.y)² = 1 is a quadratic equation in t.",
           [](const Said& s) {
             const glm::dvec3 f = scaled_origin(s), d = scaled_direction(s);
             const double size = glm::length(f) * glm::length(d);
             EXPECT_TRUE(are_equal(s.n["a"], glm::dot(d, d), glm::dot(d, d)));
             EXPECT_TRUE(are_equal(s.n["b"], 2 * glm::dot(f, d), 2 * size));
             EXPECT_TRUE(are_equal(s.n["c"], glm::dot(f, f) - 1, glm::dot(f, f) + 1));
           }},
          {"The ray is at the cylinder's height between the planes z = # and z = #: from t = e₀ to t = e₁.",
           [](const Said& s) {
             const double o = s.n.origin().z, d = s.n.direction().z, height = s.n["height"];
             if (d == 0) return;  // between them for every t, or for none: then e₀ is ∞
             EXPECT_LE(s.n["e₀"], s.n["e₁"]);
             if (!std::isfinite(s.n["e₀"]) || !std::isfinite(s.n["e₁"])) return;
             const auto z = [&](const char* end) { return o + s.n[end] * d; };
             EXPECT_TRUE(are_equal(z("e₀"), d > 0 ? 0 : height, std::abs(o) + height));
             EXPECT_TRUE(are_equal(z("e₁"), d > 0 ? height : 0, std::abs(o) + height));
           }},
          {"The side is endless: of its roots s₀ = # and s₁ = # those from e₀ = # to e₁ = # are hits.",
           [](const Said& s) {
             expect_root(s, s.n["s₀"]);
             expect_root(s, s.n["s₁"]);
           }},
          {"t_c is where the ray comes nearest the axis, seen in the scaled plane.",
           [](const Said& s) {
             const glm::dvec3 f = scaled_origin(s), d = scaled_direction(s);
             EXPECT_TRUE(
                 are_equal(s.n["t_c"] * glm::dot(d, d), -glm::dot(f, d), glm::length(f) * glm::length(d)));
           }},
          {"l leads from the axis to that point and is perpendicular to d there.",
           [](const Said& s) {
             const glm::dvec3 f = scaled_origin(s), d = scaled_direction(s), l = in_plane(s.n, "l");
             const bool is_rounding = glm::length(l) <= 1e-13 * glm::length(f);  // through the axis
             EXPECT_TRUE(is_rounding || are_perpendicular(l, d, 1e-13));
             EXPECT_TRUE(are_equal(l, f + s.n["t_c"] * d, 2 * glm::length(f)));
           }},
          {"√D is half the chord, and h is half the chord measured in t: the line meets the surface h before "
           "and h after t_c.",
           [](const Said& s) {
             if (!(s.n["D"] > 0)) return;
             const double h = s.n["h"], t = s.n["t_c"];
             if (s.n.has("rx")) {
               expect_on_circle(s, t - h);
               expect_on_circle(s, t + h);
               return;
             }
             const glm::dvec3 f = s.n.vector("f"),
                              d = s.n.has_vector("d̂") ? s.n.vector("d̂") : s.n.direction();
             for (const double hit : {t - h, t + h}) {
               const glm::dvec3 p = f + hit * d;
               const double length = glm::length(f) + std::abs(hit) * glm::length(d);
               EXPECT_TRUE(are_equal(glm::dot(p, p), s.n["r"] * s.n["r"], length * length));
             }
           }},
          {"Where D < 0 there is no chord.",
           [](const Said& s) {
             if (std::isfinite(s.n["D"]) && std::isfinite(s.n["1/a"])) {
               EXPECT_EQ(std::isnan(s.n["h"]), s.n["D"] < 0) << s.n["D"];
             }
           }},
          {"Only t in [0, 1] is kept, so hits beyond the tip of the direction are lost.", [](const Said& s) {
             for (const double t : values_of(s.report.claim())) {
               EXPECT_GE(t, 0);
               EXPECT_LE(t, 1);
             }
           }}};
}

}  // namespace rayproof::viz
