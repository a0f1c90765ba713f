#pragma once
#include <rayproof/triangle.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Triangle<double>> {
  static constexpr const char* type = "triangle";

  template <class S, class Visit>
  static void fields(S& triangle, Visit&& visit) {
    visit("a", triangle.a);
    visit("b", triangle.b);
    visit("c", triangle.c);
  }

  /// A triangle of zero area is a question with an answer: `degenerate`.
  template <class Show>
  static std::string in_words(const Triangle<double>& /*nothing of it is short*/, Show&& /*no number*/) {
    return "a triangle";
  }

  static void validate(const Triangle<double>& /*any*/) {}
};

}  // namespace rayproof
