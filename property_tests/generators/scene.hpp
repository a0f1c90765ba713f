#pragma once
/// \file
/// A ray and a shape while a generator still works on them, in double; rounded once at the end.

#include <cmath>
#include <limits>
#include <optional>

#include "case/accepted.hpp"
#include "case/each_number.hpp"
#include "case/json/number_text.hpp"
#include "generators/draw.hpp"

namespace rayproof {

/// Where the pieces of a case are put together.
struct Scene {
  glm::dvec3 origin{};
  glm::dvec3 direction{0, 0, 1};
  Shape shape{};
  double aimed_at = 0;  ///< the t of the point that the ray was aimed at
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();
  std::optional<glm::dmat4> transform{};
};

/// A number, vector, matrix, list, shape or question with every number rounded to the precision.
template <class V>
[[nodiscard]] V rounded(Precision precision, V value) {
  each_number(value, [&](double& x) { x = round_to(precision, x); });
  return value;
}

/// The question that a scene asks once its numbers are rounded.
[[nodiscard]] inline RayQuestion question(Precision precision, const Scene& s) {
  const auto to_precision = [&](const auto& value) { return rounded(precision, value); };
  RayQuestion asked{
      {to_precision(s.origin), to_precision(s.direction), to_precision(s.t_min), to_precision(s.t_max)},
      std::visit([&](const auto& shape) -> Shape { return to_precision(shape); }, s.shape)};
  if (s.transform) asked.transform = to_precision(*s.transform);
  return asked;
}

/// The first of the questions from `draw()` that the format takes: rounding can make vectors dependent and a
/// normal zero.
[[nodiscard]] RayQuestion first_accepted(auto&& draw) {
  for (;;) {
    RayQuestion asked = draw();
    if (is_accepted(asked)) return asked;
  }
}

}  // namespace rayproof
