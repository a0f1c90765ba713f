#pragma once
/// \file
/// A ray and a sphere while a generator still works on them.

#include "generators/aim.hpp"

namespace rayproof {

struct SphereScene : RayScene {
  glm::dvec3 center{};
  double radius = 1;
};

template <class T>
[[nodiscard]] RayQuestion question(const SphereScene& scene) {
  return question<T>(scene, Sphere<double>{scene.center, scene.radius});
}

/// A sphere of a radius between 0.1 and 5 within a box 20 wide around the origin.
[[nodiscard]] inline SphereScene sphere_in_a_room(Random& random) {
  SphereScene scene;
  scene.center = draw::vector([&] { return random.uniform(-10, 10); });
  scene.radius = random.uniform(0.1, 5);
  return scene;
}

}  // namespace rayproof
