#include "properties/diagnosis/models/cylinders/side_equation.hpp"

#include <cmath>
#include <numeric>

#include "properties/diagnosis/models/cylinder_parts.hpp"
#include "properties/diagnosis/models/cylinders/side.hpp"

namespace rayproof::diagnosis {
namespace {

/// What a subject answers that takes that equation for the side's.
Answers with_side_of(const Case& one, const ReducedEquation& equation) {
  return with_side_hits(one, listed(roots_by(-equation.h, equation.discriminant(), equation.a)));
}

}  // namespace

Answers side_as_distance(const Case& one, const Answer& /*exact*/) {
  const std::vector<double> roots = roots_of_side(one);
  if (roots.empty()) return {};
  const auto& cylinder = *shape_in<Cylinder<double>>(one);
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double in_radii = std::sqrt(reduced_equation(one)->a),
               in_lengths = glm::length(glm::dvec2(ray.direction));
  Answers answers;
  for (const double length : {in_radii, in_lengths, in_radii * cylinder.rx}) {
    const std::vector<double> side{length * roots[0], length * roots[1]};
    answers.push_back(with_side_hits(one, side).front());
    answers.emplace_back(between_ends(one, side[0], side[1], cylinder.height));
  }
  return answers;
}

Answers side_chord_undivided(const Case& one, const Answer& /*exact*/) {
  const std::vector<double> roots = roots_of_side(one);
  if (roots.empty()) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double middle = std::midpoint(roots[0], roots[1]), half = (roots[1] - roots[0]) / 2;
  const double chord = half * glm::length(glm::dvec2(ray.direction));
  Answers answers;
  for (const double wrong : {chord, chord / glm::length(ray.direction)})
    answers.push_back(with_side_hits(one, {middle - wrong, middle + wrong}).front());
  return answers;
}

Answers side_constant_wrong(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  const auto equation = cylinder == nullptr ? std::nullopt : reduced_equation(one);
  Answers answers;
  if (!equation) return answers;
  const auto& [rx, ry, height, capped] = *cylinder;
  for (const double constant : {rx, ry, rx * rx, ry * ry, rx * ry, 0.0})
    answers.push_back(with_side_of(one, {equation->a, equation->h, equation->c + 1 - constant}).front());
  return answers;
}

Answers side_with_z_of_direction(const Case& one, const Answer& /*exact*/) {
  const auto equation = shape_in<Cylinder<double>>(one) == nullptr ? std::nullopt : reduced_equation(one);
  Answers answers;
  if (!equation) return answers;
  const double z = ray_in_object(*ray_question(one)).direction.z;
  const double a = equation->a + z * z, h = equation->h;
  for (const double D : {h * h - a * equation->c, equation->discriminant() + z * z})
    answers.push_back(with_side_hits(one, listed(roots_by(-h, D, a))).front());
  return answers;
}

Answers direction_not_divided_by_radii(const Case& one, const Answer& /*exact*/) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec2 o = glm::dvec2(ray.origin) / glm::dvec2(cylinder->rx, cylinder->ry), d(ray.direction);
  return with_side_of(one, {glm::dot(d, d), glm::dot(o, d), glm::dot(o, o) - 1});
}

}  // namespace rayproof::diagnosis
