#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "properties/diagnosis/hypothesis.hpp"
#include "properties/engine/engine.hpp"
#include "unit/properties/guests/stranger.hpp"

namespace rayproof {
namespace {

/// Right, but for rays that meet a triangle's plane with |n·d| below 10^power: they are said to miss.
template <int power>
Answer without_small_slopes(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const auto* triangle = asked == nullptr ? nullptr : std::get_if<Triangle<double>>(&asked->shape);
  if (triangle == nullptr || asked->transform) return nearest_alone(one);
  const glm::dvec3 normal = cross(triangle->b - triangle->a, triangle->c - triangle->a);
  const double slope = dot(normal, asked->ray.direction);
  return std::abs(slope) < std::pow(10.0, power) ? Answer{RayAnswer{}} : nearest_alone(one);
}

/// The names of the causes that a run finds.
std::set<std::string> causes_of(Answer (*answer)(const Case&)) {
  Settings settings;
  settings.cases = 1000;
  settings.precisions = {Precision::float64};
  settings.properties = {"verdict", "ascending"};
  const std::vector<Subject> all{guest("triangle", answer)};
  std::set<std::string> names;
  for (const Finding& one : run_plan(make_plan(settings, all), {}, {}, never_stopped).findings)
    names.emplace(one.cause == nullptr ? "none" : one.cause->name);
  return names;
}

TEST(Consultation, NamesTheSizeBelowWhichAProgramTakesSomethingForZero) {
  using Names = std::set<std::string>;
  EXPECT_EQ(causes_of(without_small_slopes<-10>), Names{"slope-small-1e-10"});
  EXPECT_EQ(causes_of(without_small_slopes<-3>), Names{"slope-small-1e-3"});
  EXPECT_EQ(causes_of(without_small_slopes<-5>), Names{"slope-small-1e-5"});
  EXPECT_EQ(causes_of(without_small_slopes<-7>), Names{"slope-small-1e-7"});
}

}  // namespace
}  // namespace rayproof
