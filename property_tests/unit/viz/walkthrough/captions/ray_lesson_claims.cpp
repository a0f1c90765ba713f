#include <cmath>

#include "unit/viz/walkthrough/captions/lesson_caption.hpp"

namespace rayproof::viz {
namespace {

bool is_about(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-6; }
bool is_about(double a, double b) { return std::abs(a - b) < 1e-6; }

/// The nearest sphere of `raycasting` that a ray from the eye meets: 0, 1, or 2 for none.
std::size_t nearest_ball(const glm::dvec3& o, const glm::dvec3& d, double* t = nullptr) {
  const glm::dvec3 centres[] = {{0, 0, 0.2}, {1.2, -0.4, 0.6}};
  const double radii[] = {0.75, 0.4};
  std::size_t nearest = 2;
  double least = INFINITY;
  for (std::size_t k = 0; k < 2; ++k) {
    const glm::dvec3 f = o - centres[k];
    const double a = glm::dot(d, d), b = glm::dot(d, f),
                 D = b * b - a * (glm::dot(f, f) - radii[k] * radii[k]);
    if (D < 0 || (-b - std::sqrt(D)) / a > least) continue;
    least = (-b - std::sqrt(D)) / a;
    nearest = k;
  }
  if (t != nullptr) *t = least;
  return nearest;
}

/// Through the centre of a pixel of an image of 8 × 6, half as wide as far.
glm::dvec3 through_pixel(int i, int j) {
  const glm::dvec3 eye(3.2, -2.4, 1.6), w = glm::normalize(eye - glm::dvec3(0, 0, 0.2));
  const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), w)), v = glm::cross(w, u);
  return 0.5 * ((i + 0.5) / 4 - 1) * u + 0.375 * (1 - (j + 0.5) / 3) * v - w;
}
const glm::dvec3 eye_of_image(3.2, -2.4, 1.6);

}  // namespace

std::vector<LessonClaim> ray_lesson_claims() {
  return {
      {"ray", "p(0) = o + 0·d: the ray begins there.",
       [](const LessonSaid& s) { EXPECT_EQ(s.n.vector("p(0)"), s.n.vector("o")); }},
      {"ray", "p(1) is the tip of d, drawn from the origin.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(is_about(s.n.vector("p(1)"), s.n.vector("o") + s.n.vector("d")));
       }},
      {"ray", "t is any number, not only a whole one."},
      {"ray", "A ray has no t below t_min = 0: p(-0.5) is a point of the line, not of the ray.",
       [](const LessonSaid& s) { EXPECT_EQ(std::get<RayQuestion>(s.stage.one.question).ray.t_min, 0); }},
      {"ray", "Only for a direction of length 1 are t and the distance the same number.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(is_about(s.n["distance"], glm::length(s.n.vector("p(2.5)") - s.n.vector("o"))));
         EXPECT_NE(s.n["|d|"], 1);
       }},
      {"segment", "Only t₀ is in [0, 1]: the segment ends inside the sphere, and t₁ is beyond its tip.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(s.n["t₀"] >= 0 && s.n["t₀"] <= 1);
         EXPECT_GT(s.n["t₁"], 1);
         EXPECT_LT(glm::length(s.n.vector("o") + s.n.vector("d") - s.n.vector("C")), s.n["r"]);
       }},
      {"camera", "w = (eye − center) / |eye − center| is the unit vector from the centre back to the eye.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(is_about(s.n.vector("w"), glm::normalize(s.n.vector("eye") - s.n.vector("center"))));
       }},
      {"camera", "u = up × w / |up × w| is a unit vector perpendicular to both: horizontal in the image.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(
             is_about(s.n.vector("u"), glm::normalize(glm::cross(s.n.vector("up"), s.n.vector("w")))));
       }},
      {"camera",
       "v is perpendicular to u and w and points upwards in the image; it is a unit vector already.",
       [](const LessonSaid& s) {
         const glm::dvec3 v = s.n.vector("v");
         EXPECT_TRUE(are_perpendicular(v, s.n.vector("u")));
         EXPECT_TRUE(are_perpendicular(v, s.n.vector("w")));
         EXPECT_TRUE(is_about(glm::length(v), 1));
         EXPECT_GT(glm::dot(v, s.n.vector("up")), 0);
       }},
      {"camera", "x and y go from -1 to 1 over the image; the centre is half a pixel from the corner (i, j).",
       [](const LessonSaid& s) {
         EXPECT_TRUE(is_about(s.n["x"], 2 * 4.5 / 8 - 1));
         EXPECT_TRUE(is_about(s.n["y"], 1 - 2 * 2.5 / 6));
       }},
      {"camera",
       "There the image is 2·half_w wide and 2·half_h high, so x and y from -1 to 1 are multiplied by half_w "
       "and half_h, the tangents of half the angles of view.",
       [](const LessonSaid& s) {
         EXPECT_TRUE(is_about(s.n["α"], s.n["half_w"] * s.n["x"]));
         EXPECT_TRUE(is_about(s.n["β"], s.n["half_h"] * s.n["y"]));
       }},
      {"camera", "d leads from the eye to that point, so t is 1 on the image plane.",
       [](const LessonSaid& s) {  // the plane lies at distance 1 along -w
         EXPECT_TRUE(is_about(glm::dot(s.n.vector("d"), s.n.vector("w")), -1));
         EXPECT_TRUE(is_about(s.n.vector("d"), through_pixel(4, 2)));
       }},
      {"raycasting", "8 × 6 pixels, and two spheres behind them."},
      {"raycasting", "Through the centre of pixel (4, 2): d = *",
       [](const LessonSaid& s) {
         const std::vector<double> d = numbers_in(s.sentence.substr(s.sentence.find("d = ")));
         EXPECT_TRUE(is_about({d.at(0), d.at(1), d.at(2)}, through_pixel(4, 2)));
       }},
      {"raycasting", "The nearest hit of the * sphere: *"},
      {"raycasting", "min(#) = #: the second object is what is seen.",
       [](const LessonSaid& s) {
         double t = 0;
         EXPECT_EQ(nearest_ball(eye_of_image, through_pixel(4, 2), &t), 1U);
         EXPECT_TRUE(is_about(numbers_in(s.sentence).at(2), t)) << t;
       }},
      {"raycasting", "The ray through pixel (1, 4) meets no object: it keeps the background's colour.",
       [](const LessonSaid&) { EXPECT_EQ(nearest_ball(eye_of_image, through_pixel(1, 4)), 2U); }},
      {"raycasting", "The loop runs over all 8 × 6 pixels."},
      {"raycasting", "# of 48 pixels see an object: plain the first, with a diagonal the second.",
       [](const LessonSaid& s) {
         int seen = 0;
         for (int i = 0; i < 48; ++i)
           seen += nearest_ball(eye_of_image, through_pixel(i % 8, i / 8)) < 2 ? 1 : 0;
         EXPECT_EQ(numbers_in(s.sentence).at(0), seen);
       }}};
}

}  // namespace rayproof::viz
