/// \file
/// What a lesson's subtitle says of its own case holds of the exact numbers; a subtitle that is not entered
/// here, or entered otherwise, fails.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "case/reader.hpp"
#include "unit/viz/captions/caption.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/steps/live_values.hpp"

namespace rayproof::viz {
namespace {

/// A lesson's case, answered by the oracle and by the lesson's method.
struct Taught {
  const CaseReport& report;

  [[nodiscard]] const Case& one() const { return report.one; }
  [[nodiscard]] CaseReport by(const char* method) const { return report_lesson(report.one, method); }
  [[nodiscard]] std::vector<double> exact() const { return values_of(&report.exact); }
  [[nodiscard]] std::vector<double> claimed() const { return values_of(report.claim()); }
  [[nodiscard]] bool differ() const { return verdicts_differ(&report.exact, report.claim()); }
  [[nodiscard]] const Ray<double>& ray() const { return std::get<RayQuestion>(one().question).ray; }
  template <class S>
  [[nodiscard]] const S& shape() const {
    return std::get<S>(std::get<RayQuestion>(one().question).shape);
  }
  [[nodiscard]] const Quadratic<double>& quadratic() const {
    return std::get<Quadratic<double>>(one().question);
  }
  [[nodiscard]] const PointAndPolygon<double>& polygon() const {
    return std::get<PointAndPolygon<double>>(one().question);
  }
  [[nodiscard]] NumbersByName numbers() const {
    return NumbersByName(*report.walk, report.walk->steps.size() - 1);
  }
};

std::size_t roots_of(Quadratic<double> q, Precision precision) {
  Case one{};
  one.precision = precision;
  one.question = q;
  const Answer exact = oracle::answer(one);
  return values_of(&exact).size();
}

/// How often the polygon winds around the point.
double winding_of(const PointAndPolygon<double>& q) {
  double sum = 0;
  for (std::size_t i = 0; i < q.vertices.size(); ++i) {
    const auto& a = q.vertices[i];
    const auto& b = q.vertices[(i + 1) % q.vertices.size()];
    const double x = a.x - q.point.x, y = a.y - q.point.y, u = b.x - q.point.x, v = b.y - q.point.y;
    sum += std::atan2(x * v - y * u, x * u + y * v);
  }
  return std::abs(sum) / (2 * std::numbers::pi);
}

void expect_verdict_wrong(const Taught& t) { EXPECT_TRUE(t.differ()); }
void expect_parallel(const Taught& t) {
  const auto& plane = t.shape<PointNormalPlane>();
  EXPECT_EQ(glm::dot(plane.normal, t.ray().direction), 0);
  EXPECT_TRUE(t.exact().empty());
}
void expect_far_sphere(const Taught& t) {
  const auto& sphere = t.shape<Sphere<double>>();
  const glm::dvec3 f = t.ray().origin - sphere.center;
  const double distance = glm::length(glm::cross(f, t.ray().direction)) / glm::length(t.ray().direction);
  EXPECT_NEAR(distance / sphere.radius, 0.2, 1e-6);
  EXPECT_EQ(t.exact().size(), 2U);
  EXPECT_TRUE(t.claimed().empty());
  const NumbersByName n = t.numbers();
  const auto a = static_cast<float>(n.rounded("a")), b = static_cast<float>(n.rounded("b")),
             c = static_cast<float>(n.rounded("c"));
  EXPECT_EQ(count_ulps(static_cast<double>(b * b), static_cast<double>(4 * a * c), Precision::float32), 2);
  EXPECT_LT(b * b, 4 * a * c);
}
void expect_turning_point(const Taught& t) {
  const Quadratic<double>& q = t.quadratic();
  const auto with = [&](int ulps) {
    return Quadratic<double>{q.a, q.b, neighbour_of(q.c, ulps, t.one().precision)};
  };
  EXPECT_EQ(roots_of(with(1), t.one().precision), 0U);
  EXPECT_EQ(roots_of(with(0), t.one().precision), 1U);
  EXPECT_EQ(roots_of(with(-1), t.one().precision), 2U);
}
void expect_half_b_away(const Taught& t) {
  EXPECT_GT(std::abs(glm::length(t.ray().direction) - 1), 0.1);
  EXPECT_TRUE(t.differ() || worst_ulps(&t.report.exact, t.report.claim(), t.one().precision) > 1e3);
}

/// The cases that a subtitle speaks of, by the lesson's name.
const std::map<std::string, std::function<void(const Taught&)>>& checks() {
  static const std::map<std::string, std::function<void(const Taught&)>> all{
      {"segment",
       [](const Taught& t) {
         Case line = t.one();
         std::get<RayQuestion>(line.question).ray.t_max = INFINITY;
         const Answer exact = oracle::answer(line);
         EXPECT_EQ(t.exact().size(), 1U);
         EXPECT_GT(values_of(&exact).at(1), 1);
       }},
      {"plane-parallel", expect_parallel},
      {"plane-inside",
       [](const Taught& t) {
         expect_parallel(t);
         const auto& plane = t.shape<PointNormalPlane>();
         EXPECT_EQ(glm::dot(plane.normal, t.ray().origin - plane.point), 0);
         EXPECT_TRUE(verdict_of(t.report.claim()).starts_with("miss"));
       }},
      {"polygon-vertex-trap",
       [](const Taught& t) {
         EXPECT_EQ(verdict_of(&t.report.exact), "inside");
         const CaseReport closed = t.by("point_in_polygon/printed_parity");
         EXPECT_EQ(verdict_of(closed.claim()), "outside");
         EXPECT_TRUE(std::ranges::any_of(t.polygon().vertices,
                                         [&](const auto& v) { return v.y == t.polygon().point.y; }));
       }},
      {"polygon-vertex-mended",
       [](const Taught& t) { EXPECT_FALSE(Taught{t.by("point_in_polygon/parity")}.differ()); }},
      {"polygon-star",
       [](const Taught& t) {
         EXPECT_EQ(verdict_of(&t.report.exact), "outside");
         EXPECT_NEAR(winding_of(t.polygon()), 2, 1e-9);
       }},
      {"quadratic-two", [](const Taught& t) { EXPECT_EQ(t.exact().size(), 2U); }},
      {"quadratic-double", expect_turning_point},
      {"quadratic-none", [](const Taught& t) { EXPECT_TRUE(t.exact().empty()); }},
      {"quadratic-cancellation",
       [](const Taught& t) {
         const auto [a, b, c] = t.quadratic();
         EXPECT_NEAR(std::sqrt(b * b - 4 * a * c), std::abs(b), 1e-5 * std::abs(b));
       }},
      {"quadratic-linear",
       [](const Taught& t) {
         EXPECT_EQ(t.quadratic().a, 0);
         EXPECT_NEAR(t.claimed().at(0), -t.quadratic().c / t.quadratic().b, 1e-6);
       }},
      {"far-sphere", expect_far_sphere},
      {"far-sphere-centred", [](const Taught& t) { EXPECT_FALSE(t.differ()); }},
      {"conservative",
       [](const Taught& t) {
         EXPECT_TRUE(t.exact().empty());
         EXPECT_FALSE(t.claimed().empty());
         const CaseReport plain = t.by("box/slabs");
         EXPECT_TRUE(values_of(plain.claim()).empty());
         const NumbersByName n = Taught{plain}.numbers();
         EXPECT_LT(n.rounded("t_exit"), n.rounded("t_entry"));
       }},
      {"slabs-parallel",
       [](const Taught& t) {
         const auto& box = t.shape<rayproof::Box<double>>();
         EXPECT_EQ(t.ray().direction.y, 0);
         EXPECT_TRUE(t.ray().origin.y == box.min.y || t.ray().origin.y == box.max.y);
       }},
      {"printed-2ac",
       [](const Taught& t) {
         const double c = t.numbers()["c"];
         for (std::size_t i = 0; i < 2; ++i)
           EXPECT_NEAR(t.claimed().at(i) * c, t.exact().at(i), 1e-4 * std::abs(t.exact().at(i)));
       }},
      {"printed-half-b", expect_half_b_away},
      {"printed-unit-direction",
       [](const Taught& t) {
         EXPECT_NEAR(t.claimed().at(0), t.exact().at(0) * glm::length(t.ray().direction), 1e-4);
       }},
      {"printed-parallelogram",
       [](const Taught& t) {
         EXPECT_TRUE(t.exact().empty());
         EXPECT_FALSE(t.claimed().empty());
       }},
      {"printed-lambda2",
       [](const Taught& t) {
         EXPECT_FALSE(t.exact().empty());
         EXPECT_TRUE(t.claimed().empty());
       }},
      {"printed-xy",
       [](const Taught& t) {
         const auto& tri = t.shape<Triangle<double>>();
         const glm::dvec3 u = tri.b - tri.a, v = tri.c - tri.a;
         EXPECT_EQ(u.x * v.y - u.y * v.x, 0);
         expect_verdict_wrong(t);
       }},
      {"printed-cylinder",
       [](const Taught& t) {
         EXPECT_GT(t.exact().at(0), 1);
         expect_verdict_wrong(t);
       }},
      {"printed-b-4ac", [](const Taught& t) {
         const auto [a, b, c] = t.quadratic();
         EXPECT_LT(std::abs(b), 50 * std::abs(4 * a * c));
         EXPECT_NEAR(std::sqrt(b * b - 4 * a * c), std::abs(b), 1e-3 * std::abs(b));
       }}};
  return all;
}

/// True by their words alone, or told by the captions below them, which lesson_captions_test.cpp checks.
constexpr std::array<std::string_view, 36> true_by_their_words{"ray",
                                                               "camera",
                                                               "raycasting",
                                                               "plane-implicit",
                                                               "plane-point-normal",
                                                               "plane-parametric",
                                                               "triangle-1",
                                                               "triangle-2",
                                                               "moller-trumbore",
                                                               "woop",
                                                               "barycentric",
                                                               "polygon-parity",
                                                               "polygon-horizontal-trap",
                                                               "polygon-in-space",
                                                               "ray-segment",
                                                               "quadratic-citardauq",
                                                               "quadratic-viete",
                                                               "sphere",
                                                               "sphere-textbook",
                                                               "sphere-half-b",
                                                               "digits",
                                                               "leak",
                                                               "leaving-a-sphere",
                                                               "acne",
                                                               "error-map",
                                                               "property-test",
                                                               "cylinder",
                                                               "cylinder-capped",
                                                               "slabs",
                                                               "parallelepiped",
                                                               "slab-intervals",
                                                               "transformed",
                                                               "transformed-normal",
                                                               "implicit-torus",
                                                               "parametric-patch",
                                                               "printed-plane"};

TEST(LessonSubtitles, EveryOneIsEnteredAndTrueOfItsLessonsCase) {
  for (const Lesson& lesson : lessons()) {
    SCOPED_TRACE(lesson.name + ": " + lesson.sentence);
    const bool is_plain = std::ranges::find(true_by_their_words, lesson.name) != true_by_their_words.end();
    const auto check = checks().find(lesson.name);
    EXPECT_NE(check != checks().end(), is_plain) << "is to be entered once";
    if (check == checks().end()) continue;
    const CaseReport report = report_lesson(read_case(lesson.case_text), lesson.method);
    check->second({report});
  }
}

}  // namespace
}  // namespace rayproof::viz
