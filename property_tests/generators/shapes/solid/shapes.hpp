#pragma once
/// \file
/// Families of unlike solids and places: axis-parallel rays, flat solids, from inside, far away. `Kind` is
/// Boxes or Oblique.

#include "generators/shapes/solid/scenes.hpp"

namespace rayproof::solid_family {

struct AxisParallelText {
  static constexpr const char* name = "axis_parallel";
  static constexpr const char* description =
      "one or two components of the direction are exactly 0 or -0, some in the plane of a face";
};
template <class Kind>
struct AxisParallel : AxisParallelText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = random.one_in(2) ? Kind::whole(random) : Kind::in_a_room(random);
    const auto anywhere = [&] { return random.uniform(-0.3, 1.3); };
    const glm::dvec3 target = at(frame, place(random, random.one_in(3) ? 1 : 0, anywhere));
    glm::dvec3 sight = draw::vector([&] { return draw::magnitude<double>(random, -2, 0); });
    const int first = random.between(0, 2);
    for (int k = random.between(1, 2); k > 0; --k) sight[(first + k) % 3] *= 0;
    Scene scene;
    look_along(random, scene, target, sight, 20);
    scene.shape = Kind::shape(frame);
    return scene;
  }
};

struct FlatText {
  static constexpr const char* name = "flat";
  static constexpr const char* description = "the solid is nearly flat, or exactly where it may be";
};
template <class Kind>
struct Flat : FlatText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = Kind::flat(random);
    Scene scene;
    const glm::dvec3 target = at(frame, draw::vector([&] { return random.uniform(-0.2, 1.2); }));
    const glm::dvec3 sight = random.one_in(4) ? whole_vector(random, 1) : draw::unit_vector(random);
    look_along(random, scene, target, sight, 20);
    scene.shape = Kind::shape(frame);
    return scene;
  }
};

struct InsideText {
  static constexpr const char* name = "inside";
  static constexpr const char* description = "the origin lies inside";
};
template <class Kind>
struct Inside : InsideText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = Kind::in_a_room(random);
    Scene scene;
    scene.origin = at(frame, draw::vector([&] { return random.uniform(0.001, 0.999); }));
    scene.direction = random.one_in(3) ? whole_vector(random, 3) : any_direction(random);
    scene.shape = Kind::shape(frame);
    return scene;
  }
};

struct FarText {
  static constexpr const char* name = "far";
  static constexpr const char* description =
      "the solid is 1e2 to 1e6 sizes away, half the time aimed near an edge";
};
template <class Kind>
struct Far : FarText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = Kind::in_a_room(random);
    Scene scene;
    const glm::dvec3 target = at(frame, place(random, random.one_in(2) ? 2 : 0));
    look_from_afar(random, scene, target, 1);
    scene.shape = Kind::shape(frame);
    return scene;
  }
};

}  // namespace rayproof::solid_family
