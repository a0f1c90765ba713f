#pragma once
/// \file
/// How a question grows with its scene.

#include <string_view>

#include "case/each_number.hpp"

namespace rayproof {

/// The shape in a scene `factor` times as large about the origin of coordinates: all its numbers are lengths,
/// but for a field named normal, which has no length to grow.
template <class S>
[[nodiscard]] S grown(S shape, double factor) {
  ShapeFormat<S>::fields(shape, [factor](std::string_view name, auto& value) {
    if (name != "normal") each_number(value, [factor](double& x) { x *= factor; });
  });
  return shape;
}

/// A point in a polygon: both grow.
[[nodiscard]] inline PointAndPolygon<double> grown(PointAndPolygon<double> question, double factor) {
  const auto grow = [factor](double& x) { x *= factor; };
  each_number(question.point, grow);
  each_number(question.vertices, grow);
  return question;
}

}  // namespace rayproof
