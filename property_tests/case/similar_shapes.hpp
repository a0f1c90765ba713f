#pragma once
/// \file
/// How a question grows with its scene.

#include <string_view>

#include "case/case.hpp"
#include "case/each_number.hpp"

namespace rayproof {

/// The shape, or a point and a polygon, in a scene `factor` times as large about the origin of coordinates:
/// all its numbers are lengths, but for a field named normal, which has no length to grow.
template <class S>
[[nodiscard]] S grown(S shape, double factor) {
  ShapeFormat<S>::fields(shape, [factor](std::string_view name, auto& value) {
    if (name != "normal") each_number(value, [factor](double& x) { x *= factor; });
  });
  return shape;
}

}  // namespace rayproof
