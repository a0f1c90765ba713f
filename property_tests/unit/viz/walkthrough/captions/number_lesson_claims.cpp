#include <rayproof/spawn.hpp>

#include <algorithm>
#include <cmath>

#include "oracle/oracle.hpp"
#include "unit/viz/walkthrough/captions/lesson_caption.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/programs/report_of.hpp"

namespace rayproof::viz {
namespace {

/// The case that a step of `property-test` shows: "o = (…), d = (…), C = (…), r = …".
Case shown_case(const LessonSaid& s) {
  const std::string& caption = s.stage.steps[s.step].caption;
  const std::vector<double> x = numbers_in(caption.substr(caption.find("o = (")));
  const auto at = [&](std::size_t i) { return static_cast<double>(static_cast<float>(x.at(i))); };
  Case one = s.stage.one;
  auto& asked = std::get<RayQuestion>(one.question);
  asked.ray.origin = {at(0), at(1), at(2)};
  asked.ray.direction = {at(3), at(4), at(5)};
  asked.shape = Sphere<double>{{at(6), at(7), at(8)}, at(9)};
  return one;
}

void expect_agreement(const LessonSaid& s, bool agree) {
  const CaseReport report = report_of(shown_case(s), "sphere/textbook");
  const std::string& caption = s.stage.steps[s.step].caption;
  EXPECT_NE(verdicts_differ(&report.exact, report.claim()), agree);
  for (const std::string& verdict :
       {"Exact: " + verdict_of(&report.exact), "Computed: " + verdict_of(report.claim())})
    EXPECT_NE(caption.find(verdict + "."), std::string::npos) << verdict;
}

std::size_t count_whole(const LessonSaid& s) {
  Case one = shown_case(s);
  std::size_t count = 0;
  const auto take = [&](const glm::dvec3& p) {
    for (int i = 0; i < 3; ++i) count += p[i] == std::round(p[i]) ? 1 : 0;
  };
  const auto& asked = std::get<RayQuestion>(one.question);
  const auto& sphere = std::get<Sphere<double>>(asked.shape);
  take(asked.ray.origin);
  take(asked.ray.direction);
  take(sphere.center);
  return count + (sphere.radius == std::round(sphere.radius) ? 1 : 0);
}

/// The next ray of the step's strategy in `acne`, after the mirror direction.
Case next_ray_of(const LessonSaid& s) {
  Case next = s.stage.one;
  auto& asked = std::get<RayQuestion>(next.question);
  const Ray<float> ray = convert<float>(asked.ray);
  const Answer exact = oracle::answer(s.stage.one);
  const auto from = spawn::leave(convert<float>(std::get<Sphere<double>>(asked.shape)),
                                 point_at(ray, static_cast<float>(values_of(&exact).at(0))));
  asked.ray.origin = glm::dvec3(from.hit);
  asked.ray.direction = glm::dvec3(ray.direction - 2 * glm::dot(ray.direction, from.normal) * from.normal);
  spawn::Strategies::for_each([&]<class Strategy>(std::type_identity<Strategy>) {
    const std::string name = Strategy::name;
    if (s.stage.steps[s.step].title.starts_with("Start by '" + name + "'"))
      asked.ray.origin = glm::dvec3(Strategy::origin(from));
  });
  return next;
}

/// Where the ray of a case begins, outside of its sphere.
void expect_start(const LessonSaid& s) {
  const auto asked = std::get<RayQuestion>(next_ray_of(s).question);
  const auto& sphere = std::get<Sphere<double>>(asked.shape);
  const double height = glm::length(asked.ray.origin - sphere.center) - sphere.radius;
  EXPECT_EQ(height < 0, s.sentence.find(" below ") != std::string::npos) << height;
  EXPECT_NEAR(std::abs(height), numbers_in(s.sentence).back(), 0.01 * std::abs(height));
}

/// The sides of what is crossed in an error map: two for each wrong pixel.
void expect_wrong_pixels(const LessonSaid& s) {
  double said = -100;
  for (const double count : numbers_in(s.sentence)) said += count;
  const auto& items = s.stage.steps[s.step].items;
  const auto crosses = std::count_if(items.begin(), items.end(), [](const StageItem& item) {
    return item.role == Role::claimed && item.form == Form::segment;
  });
  EXPECT_EQ(static_cast<double>(crosses), 2 * said);
}

}  // namespace

std::vector<LessonClaim> number_lesson_claims() {
  return {
      {"property-test",
       "A generator draws the numbers; the oracle answers exactly, and the method must agree."},
      {"property-test", "o = *, d = *, C = *, r = *."},
      {"property-test", "Exact: *."},
      {"property-test", "Computed: *."},
      {"property-test", "They agree.", [](const LessonSaid& s) { expect_agreement(s, true); }},
      {"property-test", "They differ.", [](const LessonSaid& s) { expect_agreement(s, false); }},
      {"property-test", "A verdict that differs from the oracle's breaks the property."},
      {"property-test", "Ten numbers, and none of them is round.",
       [](const LessonSaid& s) { EXPECT_EQ(count_whole(s), 0U); }},
      {"property-test",
       "A simpler case is kept where it still breaks the property: here the direction has one component "
       "that is not 0.",
       [](const LessonSaid& s) {
         const glm::dvec3 d = std::get<RayQuestion>(shown_case(s).question).ray.direction;
         EXPECT_EQ((d.x == 0) + (d.y == 0) + (d.z == 0), 2);
       }},
      {"property-test",
       "It still breaks: what matters is not where the sphere is, but how far from the ray's origin.",
       [](const LessonSaid& s) {
         const Case one = shown_case(s);
         EXPECT_EQ(std::get<Sphere<double>>(std::get<RayQuestion>(one.question).shape).center, glm::dvec3(0));
       }},
      {"property-test", "Small whole numbers still break it: a case that can be computed by hand.",
       [](const LessonSaid& s) {
         EXPECT_EQ(count_whole(s), 10U);
         const Case one = shown_case(s);
         const auto& asked = std::get<RayQuestion>(one.question);
         const glm::dvec3 way = std::get<Sphere<double>>(asked.shape).center - asked.ray.origin;
         EXPECT_EQ(glm::cross(way, asked.ray.direction), glm::dvec3(0));
       }},
      {"error-map", "Filled pixels are hits, crossed ones wrong verdicts."},
      {"error-map", "Wrong of 100 pixels: textbook, float #; centred, float #; textbook, double #.",
       expect_wrong_pixels},
      {"acne", "t₀ = # is the exact one, rounded; still p(t₀) is # below the surface.", expect_start},
      {"acne", "The offset is rounded away: o′ is p.",
       [](const LessonSaid& s) {
         const auto& asked = std::get<RayQuestion>(s.stage.one.question);
         const Answer exact = oracle::answer(s.stage.one);
         const auto hit = point_at(convert<float>(asked.ray), static_cast<float>(values_of(&exact).at(0)));
         EXPECT_EQ(std::get<RayQuestion>(next_ray_of(s).question).ray.origin, glm::dvec3(hit));
       }},
      {"acne", "The start o′ is # * the surface.", expect_start},
      {"acne", "The exact next ray meets the sphere again at t = #: acne.",
       [](const LessonSaid& s) {
         const Answer again = oracle::answer(next_ray_of(s));
         ASSERT_FALSE(values_of(&again).empty());
         EXPECT_NEAR(values_of(&again)[0], numbers_in(s.sentence).at(0), 0.01 * values_of(&again)[0]);
       }},
      {"acne", "The exact next ray does not meet the sphere again.", [](const LessonSaid& s) {
         const Answer again = oracle::answer(next_ray_of(s));
         EXPECT_TRUE(values_of(&again).empty());
       }}};
}

}  // namespace rayproof::viz
