#pragma once
#include <rayproof/sphere.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Sphere<double>> {
  static constexpr const char* type = "sphere";

  template <class S, class Visit>
  static void fields(S& sphere, Visit&& visit) {
    visit("center", sphere.center);
    visit("radius", sphere.radius);
  }

  static void validate(const Sphere<double>& sphere) {
    if (sphere.radius < 0) throw Refusal("radius", "the sphere's radius must not be negative");
  }
};

}  // namespace rayproof
