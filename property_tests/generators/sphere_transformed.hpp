#pragma once
/// \file
/// Spheres under an affine map: translated, turned, mirrored, sheared, stretched up to a condition of 1e6.

#include <glm/matrix.hpp>

#include "generators/sphere_aimed.hpp"

namespace rayproof::sphere_family {

struct Transformed {
  static constexpr const char* name = "transformed";
  static constexpr const char* description =
      "an affine map of condition 1 to 1e6: moved, mirrored, sheared, stretched";

  /// A rotation: three unit vectors at right angles.
  [[nodiscard]] static glm::dmat3 rotation(Random& random) {
    const glm::dvec3 x = draw::unit_vector(random);
    const glm::dvec3 y = draw::perpendicular(random, x);
    return {x, y, glm::cross(x, y)};
  }

  /// A stretch by factors of which the greatest is `condition` times the least; mirrored half the time.
  [[nodiscard]] static glm::dmat3 stretch(Random& random, double condition) {
    const double middle = std::exp(random.uniform(0, std::log(condition)));
    const double mirror = random.one_in(2) ? -1 : 1;
    const double size = std::exp2(random.uniform(-2, 2)) / std::sqrt(condition);
    return {glm::dvec3(mirror * size, 0, 0), glm::dvec3(0, middle * size, 0),
            glm::dvec3(0, 0, condition * size)};
  }

  [[nodiscard]] static glm::dmat3 linear_part(Random& random) {
    switch (random.between(0, 4)) {
      case 0:
        return glm::dmat3(1);
      case 1:
        return rotation(random);
      case 2: {
        glm::dmat3 shear(1);
        shear[random.between(1, 2)][0] = random.uniform(-10, 10);
        return shear;
      }
      case 3:
        return stretch(random, std::pow(10, random.uniform(0, 2)));
      default:
        return rotation(random) * stretch(random, std::pow(10, random.uniform(0, 6))) * rotation(random);
    }
  }

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene;
    scene.radius = random.one_in(2) ? 1 : random.uniform(0.1, 5);
    if (random.one_in(2)) scene.center = draw::vector([&] { return random.uniform(-2, 2); });
    const glm::dvec3 target =
        scene.center + scene.radius * random.uniform(0, 1.6) * draw::unit_vector(random);
    look_at(scene, target, draw::unit_vector(random), random.uniform(0, 10), direction_length(random));

    // The scene was laid out in the sphere's own space; the ray goes along into the world.
    const glm::dmat3 linear = linear_part(random);
    const glm::dvec3 moved_by = draw::vector([&] { return random.uniform(-10, 10); });
    scene.origin = linear * scene.origin + moved_by;
    scene.direction = linear * scene.direction;
    glm::dmat4 whole(linear);
    whole[3] = glm::dvec4(moved_by, 1);
    scene.transform = whole;
    return question<T>(scene);
  }
};

}  // namespace rayproof::sphere_family
