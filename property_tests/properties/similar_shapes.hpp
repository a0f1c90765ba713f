#pragma once
/// \file
/// How each shape grows with its scene: one function a shape.

#include <rayproof/sphere.hpp>

namespace rayproof {

/// The shape in a scene `factor` times as large about the origin of coordinates.
[[nodiscard]] inline Sphere<double> grown(const Sphere<double>& sphere, double factor) {
  return {factor * sphere.center, factor * sphere.radius};
}

}  // namespace rayproof
