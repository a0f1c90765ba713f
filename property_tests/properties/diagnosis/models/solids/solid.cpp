#include "properties/diagnosis/models/solids/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/curved/root_formula.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

template <class DoChange>
std::vector<Case> with_sphere(const Case& one, DoChange&& change) {
  return with_shape<Sphere<double>>(one, [&](RayQuestion& /*asked*/, Sphere<double>& sphere) {
    change(sphere);
    return true;
  });
}

/// The same of a sphere alone.
std::optional<ReducedEquation> sphere_equation(const Case& one) {
  return shape_in<Sphere<double>>(one) == nullptr ? std::nullopt : reduced_equation(one);
}

}  // namespace

std::vector<Case> radius_squared(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius *= sphere.radius; });
}
std::vector<Case> radius_doubled(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius *= 2; });
}
std::vector<Case> radius_halved(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius /= 2; });
}
std::vector<Case> radius_one(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius = 1; });
}
std::vector<Case> sphere_at_zero(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.center = glm::dvec3(0); });
}
std::vector<Case> sphere_mirrored(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.center = -sphere.center; });
}

Answers sphere_without_sign(const Case& one, const Answer& /*exact*/) {
  const auto equation = sphere_equation(one);
  if (!equation || equation->discriminant() >= 0) return {};
  const double D = -equation->discriminant();
  Answers answers = with_roots(one, roots_by(-equation->h, D, equation->a));
  for (Answer& other : with_roots(one, without_cancelling(*equation, D))) answers.push_back(std::move(other));
  return answers;
}

Answers radius_for_square(const Case& one, double times) {
  const auto equation = sphere_equation(one);
  if (!equation) return {};
  const double radius = shape_in<Sphere<double>>(one)->radius;
  ReducedEquation rooted = *equation;
  rooted.c += radius * radius - times * radius;
  const auto hits = [&](bool is_near, double D) {
    return with_roots(one, is_near ? roots_by(-rooted.h, std::max(D, 0.0), rooted.a) : std::nullopt).front();
  };
  const double own = equation->discriminant(), other = rooted.discriminant();
  return {hits(other >= 0, other), hits(own >= 0, other), hits(other >= 0, own)};
}

Answers radius_square_added(const Case& one, const Answer& /*exact*/) {
  auto equation = sphere_equation(one);
  if (!equation || shape_in<Sphere<double>>(one)->radius == 0) return {};
  equation->c += 2 * std::pow(shape_in<Sphere<double>>(one)->radius, 2);
  return with_roots(one, roots_by(-equation->h, equation->discriminant(), equation->a));
}

Answers nearest_point_of_line(const Case& one, const Answer& exact) {
  const auto equation = sphere_equation(one);
  if (!equation || hits_of_line(one).hits.count == 0) return {};
  RayAnswer nearest;
  nearest.hits.push_back(-equation->h / equation->a);
  const bool is_hit = std::get<RayAnswer>(exact).hits.count > 0;
  Answers answers{hits_where(nearest, [&](double t) { return in_interval(ray_question(one)->ray, t); })};
  if (is_hit) answers.push_back(nearest);
  // From inside it may take the far hit.
  if (is_hit && hits_of_line(one).hits.t[0] < ray_question(one)->ray.t_min) answers.push_back(exact);
  return answers;
}

Answers t_from_scaled_origin(const Case& one, const Answer& /*exact*/) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr || sphere->radius == 0) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec3 moved = (ray.origin - sphere->center) / sphere->radius;
  RayAnswer line = hits_of_line(one), admitted = line;
  admitted.hits = {};
  for (double& t : line.hits.t) {
    const bool is_hit = &t < line.hits.t.data() + line.hits.count && in_interval(ray_question(one)->ray, t);
    t = glm::length(point_at(ray, t) - moved);
    if (is_hit) admitted.hits.push_back(t);
  }
  // The interval is compared with what is computed, or with the right t.
  return {hits_where(line, [&](double t) { return in_interval(ray_question(one)->ray, t); }),
          hits_where(admitted, [](double) { return true; })};
}

Answers half_chord(const Case& one, const Answer& exact) {
  if (shape_in<Sphere<double>>(one) == nullptr || std::get<RayAnswer>(exact).hits.count == 0) return {};
  const RayAnswer line = hits_of_line(one);
  if (line.hits.count < 2) return {};
  return hit_at(one, (line.hits.t[1] - line.hits.t[0]) / 2, true);
}

Answers half_chord_by_difference(const Case& one, const Answer& /*exact*/) {
  const auto equation = sphere_equation(one);
  if (!equation) return {};
  const double radius = shape_in<Sphere<double>>(one)->radius;
  const double distance = std::sqrt(std::max(0.0, radius * radius - equation->discriminant() / equation->a));
  if (distance > radius) return {};
  const double middle = -equation->h / equation->a, half = (radius - distance) / std::sqrt(equation->a);
  return with_roots(one, std::array{middle - half, middle + half});
}

Answers flat_box_missed(const Case& one, const Answer& exact) {
  const auto* box = shape_in<Box<double>>(one);
  if (box == nullptr || std::get<RayAnswer>(exact).hits.count == 0) return {};
  const bool is_flat = box->min.x == box->max.x || box->min.y == box->max.y || box->min.z == box->max.z;
  return is_flat ? Answers{RayAnswer{}} : Answers{};
}

Answers sphere_of_no_radius_missed(const Case& one, const Answer& exact) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  return sphere != nullptr && sphere->radius == 0 && finds_something(exact) ? Answers{RayAnswer{}}
                                                                            : Answers{};
}

Answers centre_behind_missed(const Case& one, const Answer& exact) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr || !finds_something(exact)) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const bool is_behind = glm::dot(sphere->center - ray.origin, ray.direction) < 0;
  return is_behind ? Answers{RayAnswer{}} : Answers{};
}

Answers centre_beyond_missed(const Case& one, const Answer& exact) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr || !finds_something(exact)) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double length = glm::distance(sphere->center, ray.origin);
  Answers answers;
  for (const double far : {length / glm::length(ray.direction), length})
    answers.push_back(far > ray.t_max ? Answer{RayAnswer{}} : exact);
  return answers;
}

std::vector<Case> max_as_size(const Case& one) {
  return with_shape<Box<double>>(one, [](RayQuestion& /*asked*/, Box<double>& box) {
    const glm::dvec3 low = box.min, other = box.min + box.max;  // on either side of min
    box.min = glm::min(low, other);
    box.max = glm::max(low, other);
    return true;
  });
}

}  // namespace rayproof::diagnosis
