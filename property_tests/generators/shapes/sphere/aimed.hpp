#pragma once
/// \file
/// Sphere families aimed at what is known to be hard for the eye of a needle: tangents, surfaces, insides,
/// interval ends, and the everyday case beside them.

#include <algorithm>

#include "generators/shapes/sphere/scene.hpp"

namespace rayproof::sphere_family {

struct Everyday {
  static constexpr const char* name = "random";
  static constexpr const char* description = "a sphere in a room, about half the rays hit";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene = sphere_in_a_room(random);
    const glm::dvec3 n = draw::unit_vector(random);
    const glm::dvec3 target = scene.center + scene.radius * random.uniform(0, 1.6) * n;
    look_at(random, scene, target);
    loosen(random, scene);
    return question<T>(scene);
  }
};

struct Grazing {
  static constexpr const char* name = "grazing";
  static constexpr const char* description =
      "the line passes the centre at r(1 ± a few ulps … 1e-3), or touches";

  /// An exact tangent: a whole-number rotation matrix times its own length N keeps everything whole.
  [[nodiscard]] static SphereScene tangent(Random& random) {
    int w = 0, x = 0, y = 0, z = 0;
    while (w == 0 && x == 0 && y == 0 && z == 0) {
      w = random.between(-3, 3), x = random.between(-3, 3), y = random.between(-3, 3),
      z = random.between(-3, 3);
    }
    const glm::dvec3 n(w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y));
    const glm::dvec3 sight(2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x));
    SphereScene scene;
    scene.center = draw::vector([&] { return double{1} * random.between(-20, 20); });
    scene.radius = w * w + x * x + y * y + z * z;
    scene.origin = scene.center + n - double{1} * random.between(0, 9) * sight;
    scene.direction = sight;
    return scene;
  }

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    if (random.one_in(6)) return question<T>(tangent(random));
    SphereScene scene = sphere_in_a_room(random);
    const glm::dvec3 n = draw::unit_vector(random);
    const double few_ulps = std::numeric_limits<T>::digits - 2;
    const double beside = draw::magnitude<double>(random, -few_ulps, -10);
    const double length = direction_length(random), distance = random.uniform(0, 20);
    look_at(scene, scene.center + scene.radius * (1 + beside) * n, draw::perpendicular(random, n), distance,
            length);
    return question<T>(scene);
  }
};

struct Surface {
  static constexpr const char* name = "surface";
  static constexpr const char* description =
      "the origin lies on the surface or a few ulps off, as secondary rays' do";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene = sphere_in_a_room(random);
    scene.origin = scene.center + scene.radius * draw::unit_vector(random);
    for (int axis = 0; axis < 3; ++axis)
      scene.origin[axis] = draw::nudged<T>(static_cast<T>(scene.origin[axis]), random.between(-2, 2));
    scene.direction = any_direction(random);
    return question<T>(scene);
  }
};

struct Inside {
  static constexpr const char* name = "inside";
  static constexpr const char* description = "the origin lies inside, the centre included";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene = sphere_in_a_room(random);
    const double share = random.one_in(16) ? 0 : random.uniform(0, 0.999);
    scene.origin = scene.center + scene.radius * share * draw::unit_vector(random);
    scene.direction = any_direction(random);
    return question<T>(scene);
  }
};

struct Interval {
  static constexpr const char* name = "interval";
  static constexpr const char* description = "t_min or t_max at a hit or a few ulps beside it";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    SphereScene scene = sphere_in_a_room(random);
    const glm::dvec3 n = draw::unit_vector(random);
    const double length = direction_length(random);
    const double distance = random.uniform(0, 20);
    const double beside = random.uniform(0, 0.999);
    look_at(scene, scene.center + scene.radius * beside * n, draw::perpendicular(random, n), distance,
            length);
    const double half_chord = scene.radius * std::sqrt(1 - beside * beside);
    const auto near_hit = [&](double t) -> double {
      return draw::nudged<T>(static_cast<T>(t), random.one_in(2) ? 0 : random.between(-3, 3));
    };
    const double t0 = near_hit((distance - half_chord) / length);
    const double t1 = near_hit((distance + half_chord) / length);
    const int kind = random.between(0, 3);
    scene.t_min = kind == 0 ? t1 : kind == 1 ? 0 : t0;
    if (kind == 1) scene.t_max = std::max(t0, 0.0);
    if (kind == 2) scene.t_max = t1;
    if (scene.t_max < scene.t_min) std::swap(scene.t_min, scene.t_max);
    return question<T>(scene);
  }
};

}  // namespace rayproof::sphere_family
