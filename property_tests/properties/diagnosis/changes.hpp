#pragma once
/// \file
/// Changed copies of cases: what models and cures are made of.

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "case/json/number_text.hpp"
#include "oracle/oracle.hpp"
#include "properties/numbers.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof::diagnosis {

/// The ray question of a case, or null.
[[nodiscard]] inline const RayQuestion* ray_question(const Case& one) {
  return std::get_if<RayQuestion>(&one.question);
}

/// The shape of that kind in the case, or null.
template <class S>
[[nodiscard]] const S* shape_in(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  return asked == nullptr ? nullptr : std::get_if<S>(&asked->shape);
}

/// A list of the case with every number rounded to its precision; an empty one where the format refuses it.
[[nodiscard]] inline std::vector<Case> if_valid(Case one) {
  for (const CaseNumber& number : numbers_of(one)) *number.value = round_to(one.precision, *number.value);
  if (!is_valid(one)) return {};
  return {std::move(one)};
}

/// A list of the case as it is; an empty one where a number is not finite, of which the oracle can say
/// nothing.
[[nodiscard]] inline std::vector<Case> if_finite(Case one) {
  bool are_all = true;
  each_number_of(one, [&](double x) { are_all = are_all && std::isfinite(x); });
  if (!are_all) return {};
  return {std::move(one)};
}

/// A copy whose ray question `change(asked)` has changed, if the format takes it; empty where there is no ray
/// question or `change` returns false.
template <class DoChange>
[[nodiscard]] std::vector<Case> with_question(const Case& one, DoChange&& change) {
  Case copy = one;
  auto* asked = std::get_if<RayQuestion>(&copy.question);
  if (asked == nullptr || !change(*asked)) return {};
  return if_valid(std::move(copy));
}

/// The same of a case whose shape is an S: `change(asked, shape)`.
template <class S, class DoChange>
[[nodiscard]] std::vector<Case> with_shape(const Case& one, DoChange&& change) {
  return with_question(one, [&](RayQuestion& asked) {
    auto* shape = std::get_if<S>(&asked.shape);
    return shape != nullptr && change(asked, *shape);
  });
}

/// What is exact of the changed cases: the answers of a subject that reads the case so.
[[nodiscard]] inline std::vector<Answer> exact_of(const std::vector<Case>& cases) {
  std::vector<Answer> answers;
  answers.reserve(cases.size());
  for (const Case& one : cases) answers.push_back(oracle::answer(one));
  return answers;
}

/// The exact hits of the whole line through the ray.
[[nodiscard]] inline RayAnswer hits_of_line(const Case& one) {
  return std::get<RayAnswer>(oracle::answer(on_whole_line(one)));
}

/// Only those of the hits that `keep(t)` keeps; what else the answer says goes with the first hit.
template <class Keep>
[[nodiscard]] RayAnswer hits_where(const RayAnswer& all, Keep&& keep) {
  RayAnswer some;
  for (const double t : all.hits.view())
    if (keep(t)) some.hits.push_back(t);
  return some;
}

/// A point of the shape; nothing for one that the format has in one place only.
[[nodiscard]] std::optional<glm::dvec3> some_point(const Shape& shape);

/// The mean of points.
[[nodiscard]] glm::dvec3 mean_of(const std::vector<glm::dvec3>& points);
/// A point about which the shape lies, in object space, of a flat figure the mean of its vertices; nothing
/// for what has no end.
[[nodiscard]] std::optional<glm::dvec3> middle_of(const Shape& shape);

/// The size of the largest number that gives a length of the scene: origin and shape.
[[nodiscard]] inline double size_of_scene(Case one) {
  double size = 0;
  for (const CaseNumber& number : numbers_of(one)) {
    const bool is_length = !number.field.starts_with("ray.") || number.field == "ray.origin";
    if (is_length && number.field != "normal") size = std::max(size, std::abs(*number.value));
  }
  return size;
}

}  // namespace rayproof::diagnosis
