#pragma once
/// \file
/// Sphere families drawn number by number: any finite bits, any exponent, numbers by name.

#include <algorithm>

#include "generators/scene.hpp"

namespace rayproof::sphere_family {

/// The ray and sphere made of nine numbers from `number()` and the whole line or the default interval.
template <class T, class Number>
[[nodiscard]] RayQuestion from_numbers(Random& random, Number&& number) {
  SphereScene scene;
  scene.center = draw::vector(number);
  scene.radius = std::abs(static_cast<double>(number()));
  scene.origin = draw::vector(number);
  do {
    scene.direction = draw::vector(number);
  } while (scene.direction == glm::dvec3(0));
  if (random.one_in(4)) {
    const double t0 = number();
    const double t1 = number();
    scene.t_min = std::min(t0, t1);
    scene.t_max = std::max(t0, t1);
  }
  return question<T>(scene);
}

struct BitPatterns {
  static constexpr const char* name = "bit_patterns";
  static constexpr const char* description = "every finite bit pattern as likely as every other";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return from_numbers<T>(random, [&] { return draw::bit_pattern<T>(random); });
  }
};

struct Special {
  static constexpr const char* name = "special";
  static constexpr const char* description =
      "0, -0, ±1, subnormals, the greatest number, powers of two, small integers";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return from_numbers<T>(random, [&] { return draw::special<T>(random); });
  }
};

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
