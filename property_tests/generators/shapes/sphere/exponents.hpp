#pragma once
/// \file
/// Spheres of any exponent.

#include "generators/shapes/sphere/scene.hpp"

namespace rayproof::sphere_family {

struct Exponents {
  static constexpr const char* name = "exponents";
  static constexpr const char* description = "scenes of one size, of any exponent the format has";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const double lowest = draw::lowest_exponent<T> + 4;
    const double highest = draw::highest_exponent<T> - 4;
    const double size = random.uniform(lowest, highest);
    const double length = random.uniform(lowest, highest);
    const auto coordinate = [&] { return draw::magnitude<T>(random, size - 3, size + 2); };
    SphereScene scene;
    scene.center = draw::vector(coordinate);
    scene.radius = std::abs(coordinate());
    scene.origin = draw::vector(coordinate);
    // Aimed at a point of the ball's bounding box, so that about half the rays hit.
    const auto shift = static_cast<int>(std::floor(length - size));  // 2^shift itself may be no double
    for (int axis = 0; axis < 3; ++axis) {
      const double target = scene.center[axis] + scene.radius * draw::symmetric<double>(random);
      scene.direction[axis] = std::ldexp(target - scene.origin[axis], shift);
    }
    RayQuestion asked = question<T>(scene);
    if (asked.ray.direction == glm::dvec3(0)) asked.ray.direction.z = std::exp2(std::floor(length));
    return asked;
  }
};

}  // namespace rayproof::sphere_family
