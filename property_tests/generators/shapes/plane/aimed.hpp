#pragma once
/// \file
/// Plane families.

#include "generators/shapes/plane/scenes.hpp"

namespace rayproof::plane_family {

struct Everyday {
  static constexpr const char* name = "random";
  static constexpr const char* description = "a plane in a room, in any of its forms; most rays hit";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Sheet sheet = in_a_room(random);
    Scene scene;
    look_at(random, scene, somewhere(random, sheet));
    if (random.one_in(2)) loosen(random, scene);
    if (random.one_in(4)) scene.direction = -scene.direction;
    scene.shape = in_some_form(random, sheet);
    return scene;
  }
};

struct NearParallel {
  static constexpr const char* name = "near_parallel";
  static constexpr const char* description = "the ray comes in at 2^-4 to an ulp off the plane";

  [[nodiscard]] static Scene scene(Random& random, int digits) {
    const Sheet sheet = in_a_room(random);
    const double angle = draw::magnitude<double>(random, -digits, -4);
    Scene scene;
    const glm::dvec3 any_way = draw::unit_vector(random);
    const glm::dvec3 off = random.uniform(-1, 1) * any_way;
    scene.origin = somewhere(random, sheet) + off;
    const glm::dvec3 slope = angle * draw::unit_vector(random);
    scene.direction = random.uniform(-2, 2) * sheet.u + sheet.v + slope;
    scene.shape = in_some_form(random, sheet);
    return scene;
  }
};

struct InPlane {
  static constexpr const char* name = "in_plane";
  static constexpr const char* description =
      "in whole numbers: the ray runs exactly in the plane, or parallel to it";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Sheet sheet = whole(random);
    const auto step = [&] { return double{1} * random.between(-3, 3); };
    const double a = step(), b = step();
    Scene scene;
    scene.origin = at(sheet, a, b);
    const double along_v = random.between(1, 3);
    scene.direction = step() * sheet.u + along_v * sheet.v;
    if (random.one_in(3)) scene.origin += whole_vector(random, 2);
    scene.shape = in_some_form(random, sheet);
    return scene;
  }
};

struct Surface {
  static constexpr const char* name = "surface";
  static constexpr const char* description =
      "the origin lies in the plane or an ulp off, as secondary rays' do";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(3);
    const Sheet sheet = exactly ? whole(random) : in_a_room(random);
    Scene scene;
    scene.origin = exactly ? exactly_somewhere(random, sheet) : somewhere(random, sheet);
    scene.direction = any_direction(random);
    scene.shape = in_some_form(random, sheet);
    return scene;
  }
};

struct Far {
  static constexpr const char* name = "far";
  static constexpr const char* description =
      "the origin, or the point that gives the plane, is 1e2 to 1e6 away";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    Sheet sheet = in_a_room(random);
    const double distance = std::pow(10, random.uniform(2, 6));
    const glm::dvec3 target = somewhere(random, sheet);
    Scene scene;
    if (random.one_in(2)) {
      look_from_afar(random, scene, target, 1);
    } else {
      look_at(random, scene, target);
      const double b = distance * random.uniform(-1, 1);
      sheet.point = at(sheet, distance * random.uniform(-1, 1), b);
    }
    scene.shape = in_some_form(random, sheet);
    return scene;
  }
};

struct TinyNormal {
  static constexpr const char* name = "tiny_normal";
  static constexpr const char* description = "the numbers that give the plane's slope are tiny";

  [[nodiscard]] static Scene scene(Random& random, int digits) {
    Sheet sheet = in_a_room(random);
    Scene scene;
    look_at(random, scene, somewhere(random, sheet));
    const double size = std::exp2(random.uniform(-digits / 4.0, -2));
    sheet.u *= size;
    sheet.v *= size;
    scene.shape = in_some_form(random, sheet);
    return scene;
  }
};

/// For the interval: half the time in whole numbers, so that the hit is exactly where the ray was aimed.
struct Cut {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(2);
    const Sheet sheet = exactly ? whole(random) : in_a_room(random);
    Scene scene;
    if (exactly)
      look_exactly(random, scene, exactly_somewhere(random, sheet));
    else
      look_at(random, scene, somewhere(random, sheet));
    scene.shape = in_some_form(random, sheet);
    return scene;
  }
};

}  // namespace rayproof::plane_family
