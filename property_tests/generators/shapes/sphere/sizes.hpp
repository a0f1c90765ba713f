#pragma once
/// \file
/// Sphere families of unlike sizes: far away, tiny, huge, and an origin so near the surface that b² >> 4ac.

#include "generators/shapes/sphere/scene.hpp"

namespace rayproof::sphere_family {

/// The exponents that stay well inside the domain of every bounded contract (method/contract.hpp, Domain).
template <class T>
inline constexpr double roomy_exponent = sizeof(T) == 4 ? 24 : 200;

/// Looks from `ratio` radii away at a point within 1.1 radii of the centre, half the time near the limb.
inline void look_from_afar(Random& random, SphereScene& scene, double ratio) {
  const glm::dvec3 sight = draw::unit_vector(random);
  const double beside = random.one_in(2) ? random.uniform(0, 1.1) : random.uniform(0.99, 1.01);
  const glm::dvec3 target = scene.center + scene.radius * beside * draw::perpendicular(random, sight);
  look_at(scene, target, sight, ratio * scene.radius, direction_length(random));
}

struct Far {
  static constexpr const char* name = "far";
  static constexpr const char* description = "the sphere is 1e2 to 1e6 radii away";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene;
    scene.radius = random.uniform(0.5, 2);
    if (random.one_in(2)) scene.center = draw::vector([&] { return random.uniform(-10, 10); });
    look_from_afar(random, scene, std::pow(10, random.uniform(2, 6)));
    return question<T>(scene);
  }
};

struct Tiny {
  static constexpr const char* name = "tiny";
  static constexpr const char* description = "a tiny radius, seen from a hundred radii or less";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene;
    scene.radius = std::exp2(random.uniform(-roomy_exponent<T>, -roomy_exponent<T> / 2));
    scene.center = draw::vector([&] { return scene.radius * random.uniform(-10, 10); });
    look_from_afar(random, scene, std::exp2(random.uniform(0, 6)));
    return question<T>(scene);
  }
};

struct Huge {
  static constexpr const char* name = "huge";
  static constexpr const char* description =
      "a huge radius: a planet, half the time from just above its ground";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene;
    scene.radius = std::exp2(random.uniform(roomy_exponent<T> / 2, roomy_exponent<T>));
    const double height = random.one_in(2) ? random.uniform(0, 2) * scene.radius : random.uniform(0, 100);
    const glm::dvec3 up = draw::unit_vector(random);
    scene.origin = (scene.radius + height) * up;
    if (random.one_in(2)) {  // The planet's ground, not its centre, lies near the origin of coordinates.
      scene.center = -scene.radius * up;
      scene.origin = height * up;
    }
    const glm::dvec3 sight = draw::unit_vector(random) - up;
    scene.direction = direction_length(random) * sight;
    if (scene.direction == glm::dvec3(0)) scene.direction = -up;
    return question<T>(scene);
  }
};

struct Cancelling {
  static constexpr const char* name = "cancelling";
  static constexpr const char* description = "b² >> 4ac: looking at the surface from just above or below it";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene = sphere_in_a_room(random);
    const glm::dvec3 up = draw::unit_vector(random);
    const double height = draw::magnitude<double>(random, -std::numeric_limits<T>::digits, -4);
    scene.origin = scene.center + scene.radius * (1 + height) * up;
    const glm::dvec3 slant = 0.7 * draw::unit_vector(random);
    const glm::dvec3 sight = (random.one_in(2) ? 1.0 : -1.0) * up + slant;
    scene.direction = direction_length(random) * sight;
    return question<T>(scene);
  }
};

}  // namespace rayproof::sphere_family
