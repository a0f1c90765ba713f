/// \file
/// What a method that is sure of most answers may leave in doubt: no ordinary ray.

#include <cmath>

#include "properties/claims/promise.hpp"
#include "properties/numbers.hpp"
#include "properties/property.hpp"

namespace rayproof {

namespace {

/// An ordinary ray is no nearer than this to a change of verdict, nor its line, nor its hit to an edge, in
/// parts of the scene's size; and no flat face is so nearly parallel to it, as the sine of the angle.
constexpr double near = 0x1p-6;
/// The numbers of an ordinary scene are within 2^±12.
constexpr int ordinary_reach = 12;
/// In units: one ulp of an ordinary hit's t moves it at least so far off the surface.
constexpr double least_slope = 0x1p-8;
/// In ulps: the exact t of an ordinary hit is no nearer to the middle between two numbers.
constexpr double near_middle = 0x1p-6;
/// The shape's ratio by which plain methods suffer (`Judgement::far`), at most.
constexpr double most_far = 16;

/// The normals of a shape's flat faces, in whose planes no ray is ordinary.
struct NormalsOfFaces {
  using Normals = std::vector<glm::dvec3>;
  Normals operator()(const ImplicitPlane& plane) const { return {plane.normal}; }
  Normals operator()(const PointNormalPlane& plane) const { return {plane.normal}; }
  Normals operator()(const ParametricPlane& plane) const { return {glm::cross(plane.u, plane.v)}; }
  Normals operator()(const Triangle<double>& triangle) const {
    return {glm::cross(triangle.b - triangle.a, triangle.c - triangle.a)};
  }
  Normals operator()(const Parallelepiped<double>& solid) const {
    const auto& e = solid.edges;
    return {glm::cross(e[0], e[1]), glm::cross(e[1], e[2]), glm::cross(e[2], e[0])};
  }
  template <class Shape>
  Normals operator()(
      const Shape& /*a box may be met along a face, others have none or no correction*/) const {
    return {};
  }
};

/// So is every ray at a face without area, whose normal is 0.
bool is_nearly_along_a_face(const RayQuestion& asked) {
  const glm::dvec3 d = asked.ray.direction;
  return std::ranges::any_of(std::visit(NormalsOfFaces{}, asked.shape), [&](const glm::dvec3& n) {
    return std::abs(glm::dot(n, d)) <= near * glm::length(n) * glm::length(d);
  });
}

/// Whether the verdict is far from a change: the judge measures how far that is where an answer is wrong.
bool has_ordinary_verdict(const Case& one, const RayAnswer& exact, double unit) {
  RayAnswer opposite;
  if (exact.hits.count == 0) opposite.hits.push_back(1);
  const oracle::Judgement judgement = oracle::judge(one, opposite);
  return judgement.margin * unit >= near && judgement.far <= most_far;
}

/// Whether a hit at t is away from edges, and t moves along the ray what it moves.
bool is_ordinary_at(double t, const Case& one, double unit) {
  RayAnswer bare, moved;
  bare.hits.push_back(t);
  moved.hits.push_back(t + 2 * unit * std::abs(t));
  return oracle::judge(one, moved).residual >= least_slope &&
         oracle::judge_details(one, bare).normal.value_or(infinity<double>) * unit >= near;
}

/// How many ulps the exact hits of an ordinary ray are from their rounded ones at most: half of one, and a
/// quarter of one beside a power of two, below which numbers lie twice as dense.
double most_ulps(const RayAnswer& exact) {
  int exponent = 0;
  const bool is_at_power = std::ranges::any_of(
      exact.hits.view(), [&](double t) { return std::abs(std::frexp(t, &exponent)) == 0.5; });
  return (is_at_power ? 0.25 : 0.5) - near_middle;
}

/// Whether all numbers of a case but zeros and endless ends are of ordinary size.
bool has_ordinary_numbers(const Case& one) {
  bool is_within = true;
  each_number_of(one, [&](double x) {
    is_within = is_within && (x == 0 || std::isinf(x) || std::abs(std::logb(x)) <= ordinary_reach);
  });
  return is_within;
}

bool is_ordinary(const Case& one) {
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  const double unit = roundoff_of(one.precision);
  return has_ordinary_verdict(one, exact, unit) &&
         (exact.hits.count == 0 || oracle::judge(one, exact).ulp <= most_ulps(exact)) &&
         std::ranges::all_of(exact.hits.view(), [&](double t) { return is_ordinary_at(t, one, unit); });
}

/// The oracle is asked of what is in doubt alone, which is little.
Ruling sure(Trial& trial) {
  const auto is_in_doubt = trial.subject().is_in_doubt;
  if (is_in_doubt == nullptr || is_transformed(trial.question())) return Ruling::outside;
  if (!trial.in_domain()) return Ruling::outside;
  const Case& one = trial.question();
  const bool is_broken = is_in_doubt(one) && has_ordinary_numbers(one) &&
                         !is_nearly_along_a_face(std::get<RayQuestion>(one.question)) && is_ordinary(one) &&
                         is_ordinary(on_whole_line(one));
  return is_broken ? Ruling::broken : Ruling::held;
}

Evidence show_sure(Trial& trial) {
  return show_answer(trial, "its bounds leave an ordinary ray to slower arithmetic");
}

}  // namespace

std::vector<Property> doubt_properties() {
  return {
      {Claim::bounded, "sure",
       "the bounds leave no ray in doubt that is far from edges, from tangents and from the middle of two "
       "numbers",
       1, sure, show_sure}};
}

}  // namespace rayproof
