#pragma once
#include <rayproof/triangle.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Triangle<double>> {
  static constexpr const char* type = "triangle";

  static void fields(auto& triangle, auto&& visit) {
    visit("a", triangle.a);
    visit("b", triangle.b);
    visit("c", triangle.c);
  }

  static void validate(const Triangle<double>& /*one of zero area has an answer, too: degenerate*/) {}
};

}  // namespace rayproof
