#pragma once
/// \file
/// Cylinder families of unlike shapes and places: far away, flat ellipses, no height, origins inside and on
/// the surface.

#include "generators/shapes/cylinder/scenes.hpp"

namespace rayproof::cylinder_family {

struct Far {
  static constexpr const char* name = "far";
  static constexpr const char* description =
      "the cylinder is 1e2 to 1e6 sizes away, half the time near its limb";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Tube tube = in_a_room(random);
    const double z = tube.height * random.unit(), share = random.uniform(0, 1.1);
    const glm::dvec3 target = at(tube, any_turn(random), share, z);
    Scene scene;
    look_from_afar(random, scene, target, 1);
    if (random.one_in(2)) {  // Turned so that it touches the side where it was aimed at.
      const Turn turn = any_turn(random);
      const glm::dvec3 sight = 0.5 * tangent(tube, turn) + glm::dvec3(0, 0, random.uniform(-0.1, 0.1));
      const double height = tube.height * random.unit();
      look_at(scene, at(tube, turn, random.uniform(0.99, 1.01), height), sight, scene.aimed_at, 1);
    }
    scene.shape = tube;
    return scene;
  }
};

struct FlatEllipses {
  static constexpr const char* name = "flat_ellipses";
  static constexpr const char* description = "one radius is up to 1e4 times the other";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    Tube tube = in_a_room(random);
    (random.one_in(2) ? tube.rx : tube.ry) *= std::pow(10, random.uniform(-4, 4));
    const double share = random.one_in(2) ? random.uniform(0, 1.5) : random.uniform(0.999, 1.001);
    const double z = tube.height * random.uniform(-0.2, 1.2);
    return looked_at(random, tube, at(tube, any_turn(random), share, z));
  }
};

struct Inside {
  static constexpr const char* name = "inside";
  static constexpr const char* description = "the origin lies inside, on the axis now and then";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Tube tube = in_a_room(random);
    Scene scene;
    const double share = random.one_in(8) ? 0 : random.uniform(0, 0.999);
    const double z = tube.height * random.uniform(0.001, 0.999);
    scene.origin = at(tube, any_turn(random), share, z);
    scene.direction = any_direction(random);
    scene.shape = tube;
    return scene;
  }
};

struct Surface {
  static constexpr const char* name = "surface";
  static constexpr const char* description =
      "the origin lies on the side or an end, or an ulp off, as secondary rays' do";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(3);
    const Tube tube = exactly ? whole(random) : in_a_room(random);
    Scene scene;
    if (exactly) {
      const double z = random.between(0, static_cast<int>(tube.height));
      scene.origin = exactly_at(tube, whole_turn(random), z);
    } else if (random.one_in(2)) {
      const double z = tube.height * random.unit();
      scene.origin = at(tube, any_turn(random), 1, z);
    } else {
      const double z = some_end(random, tube), share = random.unit();
      scene.origin = at(tube, any_turn(random), share, z);
    }
    scene.direction = any_direction(random);
    scene.shape = tube;
    return scene;
  }
};

struct NoHeight {
  static constexpr const char* name = "no_height";
  static constexpr const char* description = "a height of 0, or hardly any";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(2);
    Tube tube = exactly ? whole(random) : in_a_room(random);
    tube.height = random.one_in(2) ? 0 : std::exp2(random.uniform(-20, -4));
    if (exactly) return looked_at_exactly(random, tube, exactly_at(tube, whole_turn(random), 0));
    const double share = random.uniform(0, 1.2);
    return looked_at(random, tube, at(tube, any_turn(random), share, 0));
  }
};

/// For the interval: aimed at the side.
struct Cut {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(2);
    const Tube tube = exactly ? whole(random) : in_a_room(random);
    const double z = tube.height * (exactly ? random.between(0, 4) / 4.0 : random.unit());
    return exactly ? looked_at_exactly(random, tube, exactly_at(tube, whole_turn(random), z))
                   : looked_at(random, tube, at(tube, any_turn(random), 1, z));
  }
};

}  // namespace rayproof::cylinder_family
