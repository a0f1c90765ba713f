#pragma once
/// \file
/// The name of a shape of any type.

#include <string>

#include "case/shapes.hpp"

namespace rayproof {

/// "sphere": the case format's name of the shape's type, which is its topic's, too.
[[nodiscard]] inline std::string shape_name(const Shape& shape) {
  return std::visit([]<class S>(const S&) -> std::string { return ShapeFormat<S>::type; }, shape);
}

}  // namespace rayproof
