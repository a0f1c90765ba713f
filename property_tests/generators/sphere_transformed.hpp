#pragma once
/// \file
/// Spheres to be moved by an affine map.

#include "generators/sphere_scene.hpp"

namespace rayproof::sphere_family {

/// A sphere at the origin of its own space or near it.
struct NearItsOrigin {
  [[nodiscard]] static SphereScene scene(Random& random, int /*digits*/) {
    SphereScene scene;
    scene.radius = random.one_in(2) ? 1 : random.uniform(0.1, 5);
    if (random.one_in(2)) scene.center = draw::vector([&] { return random.uniform(-2, 2); });
    const glm::dvec3 target =
        scene.center + scene.radius * random.uniform(0, 1.6) * draw::unit_vector(random);
    look_at(scene, target, draw::unit_vector(random), random.uniform(0, 10), direction_length(random));
    return scene;
  }
};

}  // namespace rayproof::sphere_family
