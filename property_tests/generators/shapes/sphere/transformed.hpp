#pragma once
/// \file
/// Spheres to be moved by an affine map.

#include "generators/shapes/sphere/scene.hpp"

namespace rayproof::sphere_family {

/// A sphere at the origin of its own space or near it.
struct NearItsOrigin {
  [[nodiscard]] static SphereScene scene(Random& random, int /*digits*/) {
    SphereScene scene;
    scene.radius = random.one_in(2) ? 1 : random.uniform(0.1, 5);
    if (random.one_in(2)) scene.center = draw::vector([&] { return random.uniform(-2, 2); });
    const glm::dvec3 n = draw::unit_vector(random);
    const glm::dvec3 target = scene.center + scene.radius * random.uniform(0, 1.6) * n;
    const double length = direction_length(random), distance = random.uniform(0, 10);
    look_at(scene, target, draw::unit_vector(random), distance, length);
    return scene;
  }
};

}  // namespace rayproof::sphere_family
