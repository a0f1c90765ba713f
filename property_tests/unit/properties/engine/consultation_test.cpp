#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

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
std::set<std::string> causes_of(const char* topic, Answer (*answer)(const Case&),
                                std::vector<std::string> properties) {
  Settings settings;
  settings.cases = 1000;
  settings.precisions = {Precision::float64};
  settings.properties = std::move(properties);
  const std::vector<Subject> all{guest(topic, answer)};
  std::set<std::string> names;
  for (const Finding& one : run_plan(make_plan(settings, all), {}, {}, never_stopped).findings)
    names.emplace(one.cause == nullptr ? "none" : one.cause->name);
  return names;
}

std::set<std::string> causes_in_triangles(Answer (*answer)(const Case&)) {
  return causes_of("triangle", answer, {"verdict", "ascending"});
}

/// A plane n·q + d = 0 of which n is made a unit vector, and d is left as it was.
Answer with_distance_of_unit_normal(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const auto* plane = asked == nullptr ? nullptr : std::get_if<ImplicitPlane>(&asked->shape);
  if (plane == nullptr) return oracle::answer(one);
  Case other = one;
  std::get<ImplicitPlane>(std::get<RayQuestion>(other.question).shape).d *= glm::length(plane->normal);
  return oracle::answer(other);
}

/// A ray inside a plane is called parallel to it.
Answer without_rays_in_planes(const Case& one) {
  auto answer = std::get<RayAnswer>(oracle::answer(one));
  if (answer.contact == Contact::in_surface) answer.contact = Contact::parallel;
  return answer;
}

// From a program of which a second finding said that it calls rays inside the plane parallel: it calls
// parallel ones inside, too, where its plane is another one.
TEST(Consultation, HasNoCauseForWhatIsSaidOfMissesBesideAWrongPlane) {
  using Names = std::set<std::string>;
  const std::vector<std::string> judged{"residual", "contact", "ascending"};
  EXPECT_EQ(causes_of("plane", with_distance_of_unit_normal, judged), Names{"constant-as-distance"});
  EXPECT_EQ(causes_of("plane", without_rays_in_planes, judged), Names{"contact-parallel"});
}

TEST(Consultation, NamesTheSizeBelowWhichAProgramTakesSomethingForZero) {
  using Names = std::set<std::string>;
  EXPECT_EQ(causes_in_triangles(without_small_slopes<-10>), Names{"slope-small-1e-10"});
  EXPECT_EQ(causes_in_triangles(without_small_slopes<-3>), Names{"slope-small-1e-3"});
  EXPECT_EQ(causes_in_triangles(without_small_slopes<-5>), Names{"slope-small-1e-5"});
  EXPECT_EQ(causes_in_triangles(without_small_slopes<-7>), Names{"slope-small-1e-7"});
}

}  // namespace
}  // namespace rayproof
