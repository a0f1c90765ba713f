#pragma once
#include <rayproof/parallelepiped.hpp>

#include "case/independent.hpp"
#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Parallelepiped<double>> {
  static constexpr const char* type = "parallelepiped";

  template <class S, class Visit>
  static void fields(S& solid, Visit&& visit) {
    visit("corner", solid.corner);
    visit("edges", solid.edges);
  }

  template <class Show>
  static std::string in_words(const Parallelepiped<double>& /*nothing of it is short*/,
                              Show&& /*no number*/) {
    return "a parallelepiped";
  }

  static void validate(const Parallelepiped<double>& solid) {
    if (!are_independent(solid.edges[0], solid.edges[1], solid.edges[2]))
      throw Refusal("edges", "the parallelepiped's edges must not be dependent");
  }
};

}  // namespace rayproof
