#pragma once
/// \file
/// How a shape grows with its scene: the shape in a scene `factor` times as large about the origin of
/// coordinates.

#include <string_view>

#include "case/case.hpp"
#include "case/each_number.hpp"

namespace rayproof {

/// Every number of a shape is a length or a place, but those of a `normal`, which has no length to grow.
template <class S>
[[nodiscard]] S grown(S shape, double factor) {
  ShapeFormat<S>::fields(shape, [&](const std::string_view name, auto& field) {
    if (name != "normal") each_number(field, [&](double& x) { x *= factor; });
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
