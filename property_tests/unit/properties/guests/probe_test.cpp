#include "properties/guests/probe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "properties/boundary.hpp"
#include "properties/guests/guest.hpp"
#include "unit/properties/guests/stranger.hpp"

namespace rayproof {
namespace {

Abilities learnt(const std::string& topic, Answer (*answer)(const Case&)) {
  Subject one = guest(topic, answer);
  EXPECT_TRUE(learn_abilities(one, 1, {Precision::float64}, never_stopped).empty());
  return one.abilities;
}

Answer without_boundary(const Case& one) {
  const Answer exact = oracle::answer(one);
  return std::get<Position>(exact) == Position::boundary ? Answer(Position::inside) : exact;
}

Answer without_tangents(const Case& one) {
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  return exact.contact == Contact::tangent ? RayAnswer{} : exact;
}

/// Without those tangents that a formula rounds nothing at, whatever it does to the direction.
Answer without_plain_tangents(const Case& one) {
  const auto& asked = std::get<RayQuestion>(one.question);
  return runs_along_axis(asked.ray) ? without_tangents(one) : oracle::answer(one);
}

/// The nearest hit alone: of a ray that enters at its origin the exit.
Answer gives_exit_on_entering(const Case& one) {
  auto exact = std::get<RayAnswer>(oracle::answer(one));
  const bool begins_there = std::get<RayQuestion>(one.question).ray.t_min == 0;
  if (begins_there && enters_at_origin(exact)) exact.hits.t[0] = exact.hits.t[1];
  exact.hits.count = std::min<std::size_t>(exact.hits.count, 1);
  exact.nearest_only = true;
  return exact;
}

Answer without_leaving(const Case& one) {
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  return leaves_at_origin(std::get<RayQuestion>(one.question), exact) ? RayAnswer{} : exact;
}

/// A vertex that no other one is above is called outside.
Answer without_some_vertices(const Case& one) {
  const auto& [point, vertices] = std::get<PointAndPolygon<double>>(one.question);
  const bool is_highest = std::ranges::all_of(vertices, [y = point.y](const auto& v) { return v.y <= y; });
  const bool is_vertex = boundary_places(one).test(static_cast<std::size_t>(BoundaryPlace::vertex));
  return is_vertex && is_highest ? Answer(Position::outside) : oracle::answer(one);
}

bool is_at(const Case& one, BoundaryPlace place) {
  return boundary_places(one).test(static_cast<std::size_t>(place));
}

/// From a program with a bounding box that is compared by < above.
Answer without_greatest(const Case& one) {
  const Answer exact = oracle::answer(one);
  const bool is_on_boundary = std::get<Position>(exact) == Position::boundary;
  return is_on_boundary && is_at(one, BoundaryPlace::greatest) ? Answer(Position::outside) : exact;
}

Answer without_closing_side(const Case& one) {
  return is_at(one, BoundaryPlace::closing_side) ? Answer(Position::inside) : oracle::answer(one);
}

/// A line along a capped cylinder's axis is inside where x² + y² < 1, and must be where it is <= 1.
Answer without_lines_in_side(const Case& one) {
  const bool is_capped = std::get<Cylinder<double>>(std::get<RayQuestion>(one.question).shape).capped;
  return is_capped && is_at(one, BoundaryPlace::along_side) ? Answer(RayAnswer{}) : oracle::answer(one);
}

/// From a program whose branch for one sign of the determinant asks v > 0.
Answer without_edge_c_behind(const Case& one) {
  return is_at(one, BoundaryPlace::edge_c_behind) ? Answer(RayAnswer{}) : oracle::answer(one);
}

Answer without_vertices(const Case& one) {
  const bool is_vertex = boundary_places(one).test(static_cast<std::size_t>(BoundaryPlace::vertex));
  return is_vertex ? Answer(Position::outside) : oracle::answer(one);
}

/// Without all of the boundary; without what is seen of it from one side.
template <bool all>
Answer without_boundary_hits(const Case& one) {
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  const bool is_left_out = all || (exact.normal && exact.normal->x + exact.normal->y > 0);
  const bool is_on_boundary = exact.contact == Contact::edge || exact.contact == Contact::vertex;
  return is_on_boundary && is_left_out ? RayAnswer{} : exact;
}

Answer with_rays_in_planes(const Case& one) {
  auto answer = std::get<RayAnswer>(oracle::answer(one));
  if (answer.contact == Contact::in_surface)
    answer.hits.push_back(std::max(0.0, std::get<RayQuestion>(one.question).ray.t_min));
  return answer;
}

/// An open cylinder without its rims, but for a ray that runs in a rim's plane; closed caps.
Answer without_crossed_rims(const Case& one) {
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  const auto& asked = std::get<RayQuestion>(one.question);
  const auto& cylinder = std::get<Cylinder<double>>(asked.shape);
  const Ray<double> ray = ray_in_object(asked);
  if (cylinder.capped || ray.direction.z == 0) return exact;
  RayAnswer left;
  for (const double t : exact.hits.view()) {
    const double z = ray.origin.z + t * ray.direction.z;
    if (0 < z && z < cylinder.height) left.hits.push_back(t);
  }
  return left.hits.count == exact.hits.count ? exact : left;
}

/// t > 0 is asked: other ends of the interval count.
Answer without_hits_at_origin(const Case& one) {
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  return exact.hits.count > 0 && exact.hits.t[0] == 0 ? RayAnswer{} : exact;
}

/// t < t_max is asked.
Answer without_hits_at_the_end(const Case& one) {
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  const double end = std::get<RayQuestion>(one.question).ray.t_max;
  RayAnswer left = exact;
  left.hits.count = 0;
  for (const double t : exact.hits.view())
    if (t < end) left.hits.push_back(t);
  return left.hits.count == exact.hits.count ? exact : left.hits.count == 0 ? RayAnswer{} : left;
}

TEST(Probe, FindsOutWhatAnswersHold) {
  const Abilities all = learnt("sphere", oracle::answer);
  EXPECT_TRUE(all.all_hits && all.numbers && all.contact && all.point && all.normal);
  EXPECT_FALSE(all.barycentric);
  const Abilities first = learnt("sphere", nearest_alone);
  EXPECT_TRUE(first.numbers);
  EXPECT_FALSE(first.all_hits || first.contact || first.point || first.normal);
  EXPECT_FALSE(learnt("sphere", verdict_alone).numbers);
  EXPECT_TRUE(learnt("point_in_polygon", oracle::answer).boundary);
  EXPECT_FALSE(learnt("point_in_polygon", without_boundary).boundary);
}

/// The same of rays upwards alone.
Answer gives_exit_on_some_faces(const Case& one) {
  const bool is_upwards = std::get<RayQuestion>(one.question).ray.direction.y > 0;
  return is_upwards ? gives_exit_on_entering(one) : nearest_alone(one);
}

TEST(Probe, TakesForARuleOfABoxesFacesWhatIsWrongInSomeCases) {
  const BoundaryPlaces rules = learnt("box", gives_exit_on_some_faces).rules;
  EXPECT_TRUE(rules.test(static_cast<std::size_t>(BoundaryPlace::entering)));
  EXPECT_FALSE(rules.test(static_cast<std::size_t>(BoundaryPlace::leaving)));
  EXPECT_TRUE(learnt("box", nearest_alone).rules.none());
}

TEST(Probe, TakesForARuleOnlyWhatIsWrongOnMostBoundaries) {
  EXPECT_TRUE(learnt("sphere", oracle::answer).rules.none());
  using enum BoundaryPlace;
  const auto only = [](BoundaryPlace one) { return BoundaryPlaces(1U << static_cast<unsigned>(one)); };
  EXPECT_EQ(learnt("sphere", without_tangents).rules,
            only(tangent) | only(tangent_along_axis) | only(no_radius));
  EXPECT_EQ(learnt("sphere", without_plain_tangents).rules, only(tangent_along_axis) | only(no_radius));
  EXPECT_EQ(learnt("sphere", gives_exit_on_entering).rules, only(entering));
  EXPECT_EQ(learnt("box", gives_exit_on_entering).rules, only(entering));
  EXPECT_EQ(learnt("sphere", without_leaving).rules, only(leaving));
  EXPECT_EQ(learnt("point_in_polygon", without_vertices).rules, only(vertex));
  EXPECT_EQ(learnt("point_in_polygon", without_some_vertices).rules, only(vertex));
  EXPECT_EQ(learnt("point_in_polygon", without_greatest).rules, only(greatest));
  EXPECT_EQ(learnt("point_in_polygon", without_closing_side).rules, only(closing_side));
  EXPECT_EQ(learnt("cylinder", without_lines_in_side).rules, only(along_side));
  EXPECT_EQ(learnt("triangle", without_edge_c_behind).rules, only(edge_c_behind));
  EXPECT_TRUE(learnt("point_in_polygon", without_boundary).rules.none());
  EXPECT_EQ(learnt("polygon", without_boundary_hits<true>).rules, only(edge));
  EXPECT_TRUE(learnt("polygon", without_boundary_hits<false>).rules.none());
  EXPECT_EQ(learnt("plane", with_rays_in_planes).rules, only(in_surface));
  // From a program that no finding was made of: it is right in the planes of the rims, and at closed caps.
  EXPECT_EQ(learnt("cylinder", without_crossed_rims).rules, only(low_rim) | only(high_rim));
  EXPECT_EQ(learnt("plane", without_hits_at_origin).rules, only(at_origin));
  // In short numbers a triangle is hardly ever met but at its edges and vertices.
  for (const char* topic : {"triangle", "polygon", "cylinder"}) {
    SCOPED_TRACE(topic);
    EXPECT_EQ(learnt(topic, without_hits_at_the_end).rules, only(t_max));
    const bool is_solid = std::string(topic) == "cylinder";
    EXPECT_EQ(learnt(topic, without_hits_at_origin).rules,
              is_solid ? only(at_origin) | only(entering) : only(at_origin));
  }
}

TEST(Probe, GivesTheCasesThatAreNotAnswered) {
  struct Silent final : Answerer {
    void answer(std::span<const Case> /*cases*/, std::span<Outcome> outcomes) override {
      for (Outcome& outcome : outcomes) outcome = {.kind = OutcomeKind::timed_out, .sentence = "is silent"};
    }
  };
  Subject silent = guest("sphere", nullptr);
  silent.start = [] { return std::make_unique<Silent>(); };
  const auto failures = learn_abilities(silent, 1, {Precision::float32}, never_stopped);
  ASSERT_FALSE(failures.empty());
  EXPECT_EQ(failures.front().outcome.sentence, "is silent");
}

}  // namespace
}  // namespace rayproof
