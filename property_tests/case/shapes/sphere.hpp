#pragma once
#include <rayproof/sphere.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Sphere<double>> {
  static constexpr const char* type = "sphere";

  static void fields(auto& sphere, auto&& visit) {
    visit("center", sphere.center);
    visit("radius", sphere.radius);
  }

  /// A point near which the whole shape lies, for a sentence that says how far away it is.
  static glm::dvec3 middle(const Sphere<double>& sphere) { return sphere.center; }

  static std::string in_words(const Sphere<double>& sphere, auto&& show) {
    return "a sphere of radius " + show(sphere.radius);
  }

  static void validate(const Sphere<double>& sphere) {
    if (sphere.radius < 0) throw Refusal("radius", "the sphere's radius must not be negative");
  }
};

}  // namespace rayproof
