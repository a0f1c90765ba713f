#pragma once
/// \file
/// Cylinder families aimed at tangents, rims and caps, and the everyday case beside them.

#include "generators/shapes/cylinder/scenes.hpp"

namespace rayproof::cylinder_family {

struct Everyday {
  static constexpr const char* name = "random";
  static constexpr const char* description = "a cylinder in a room, open or capped, about half the rays hit";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Tube tube = in_a_room(random);
    const double share = random.uniform(0, 1.8);
    const double z = tube.height * random.uniform(-0.5, 1.5);
    Scene scene = looked_at(random, tube, at(tube, any_turn(random), share, z));
    loosen(random, scene);
    return scene;
  }
};

struct Grazing {
  static constexpr const char* name = "grazing";
  static constexpr const char* description =
      "the line passes the side at (1 ± a few ulps … 1e-3) of the radii, or touches";

  [[nodiscard]] static Scene scene(Random& random, int digits) {
    Scene scene;
    if (random.one_in(4)) {
      const Tube tube = whole(random);
      const Turn turn = whole_turn(random);
      const double z = double{1} * random.between(0, static_cast<int>(tube.height));
      const glm::dvec3 slope(0, 0, random.between(-2, 2));
      look_exactly(random, scene, exactly_at(tube, turn, z), exact_tangent(tube, turn) + slope);
      scene.shape = tube;
      return scene;
    }
    const Tube tube = in_a_room(random);
    const Turn turn = any_turn(random);
    const double beside = 1 + draw::magnitude<double>(random, 2 - digits, -10);
    const glm::dvec3 sight = 0.5 * tangent(tube, turn) + glm::dvec3(0, 0, random.uniform(-1, 1));
    const double length = direction_length(random), distance = random.uniform(0, 10);
    look_at(scene, at(tube, turn, beside, tube.height * random.unit()), sight, distance, length);
    scene.shape = tube;
    return scene;
  }
};

struct Rims {
  static constexpr const char* name = "rims";
  static constexpr const char* description =
      "the line passes through a rim: exactly, in whole numbers, or an ulp beside";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(2);
    const Tube tube = exactly ? whole(random) : in_a_room(random);
    const double z = some_end(random, tube);
    return exactly ? looked_at_exactly(random, tube, exactly_at(tube, whole_turn(random), z))
                   : looked_at(random, tube, at(tube, any_turn(random), 1, z));
  }
};

struct Caps {
  static constexpr const char* name = "caps";
  static constexpr const char* description =
      "the line passes through an end disk, near its rim half the time";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Tube tube = in_a_room(random);
    const double share =
        random.one_in(2) ? random.uniform(0, 1.2) : 1 + draw::magnitude<double>(random, -20, -6);
    const double z = some_end(random, tube);
    return looked_at(random, tube, at(tube, any_turn(random), share, z));
  }
};

struct AxisParallel {
  static constexpr const char* name = "axis_parallel";
  static constexpr const char* description =
      "the ray runs along the axis: inside, outside, in the side, or almost along it";

  [[nodiscard]] static Scene scene(Random& random, int digits) {
    const bool in_side = random.one_in(2);
    const Tube tube = in_side ? whole(random) : in_a_room(random);
    const double share = random.uniform(0, 1.3);
    Scene scene;
    scene.origin = in_side ? exactly_at(tube, whole_turn(random), 0) : at(tube, any_turn(random), share, 0);
    scene.origin.z = double{1} * random.between(-4, 12);
    const double sign = random.one_in(2) ? 1 : -1;
    scene.direction = {0, 0, sign * direction_length(random)};
    if (random.one_in(4)) scene.direction.x = draw::magnitude<double>(random, -digits, -4);
    scene.shape = tube;
    return scene;
  }
};

struct CapPlanes {
  static constexpr const char* name = "cap_planes";
  static constexpr const char* description = "the ray runs exactly in the plane of an end";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(2);
    const Tube tube = exactly ? whole(random) : in_a_room(random);
    const double z = some_end(random, tube);
    Scene scene;
    if (exactly) {
      const glm::dvec3 sight{random.between(1, 4), random.between(-4, 4), 0};
      look_exactly(random, scene, exactly_at(tube, whole_turn(random), z), sight);
    } else {
      const Turn sight = any_turn(random);
      const double length = direction_length(random), distance = random.uniform(0, 20);
      const double share = random.uniform(0, 1.3);
      look_at(scene, at(tube, any_turn(random), share, z), {sight.cosine, sight.sine, 0}, distance, length);
    }
    scene.shape = tube;
    return scene;
  }
};

}  // namespace rayproof::cylinder_family
