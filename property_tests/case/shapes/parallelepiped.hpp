#pragma once
#include <rayproof/parallelepiped.hpp>

#include "case/independent.hpp"
#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Parallelepiped<double>> {
  static constexpr const char* type = "parallelepiped";

  static void fields(auto& solid, auto&& visit) {
    visit("corner", solid.corner);
    visit("edges", solid.edges);
  }

  static void validate(const Parallelepiped<double>& solid) {
    if (!are_independent(solid.edges[0], solid.edges[1], solid.edges[2]))
      throw Refusal("edges", "the parallelepiped's edges must not be dependent");
  }
};

}  // namespace rayproof
