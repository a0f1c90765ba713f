#pragma once
/// \file
/// Triangle families of unlike shapes and places: slivers, far away, of no area, seen edge on.

#include "generators/shapes/triangle/scenes.hpp"

namespace rayproof::triangle_family {

struct Slivers {
  static constexpr const char* name = "slivers";
  static constexpr const char* description =
      "the third vertex is 2^-3 lengths beside an edge, or down to 3/4 of the digits";

  [[nodiscard]] static Scene scene(Random& random, int digits) {
    Triangle<double> triangle = in_a_room(random);
    const double thinness = std::exp2(random.uniform(-0.75 * digits, -3));
    triangle.c = triangle.a + random.uniform(-0.2, 1.2) * (triangle.b - triangle.a) + thinness * triangle.c;
    return looked_at(random, triangle, in_or_beside(random, triangle));
  }
};

struct Upright {
  static constexpr const char* name = "upright";
  static constexpr const char* description =
      "in whole numbers: perpendicular to a coordinate plane or two, hit inside or on an edge";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    Triangle<double> triangle = whole(random);
    const glm::dvec3 way = triangle.b - triangle.a;
    const int axis = random.between(0, 2);
    triangle.c = triangle.a;  // across the others' way, straight along an axis
    triangle.c[axis] += random.one_in(2) ? 4 : -3;
    if (way[(axis + 1) % 3] == 0 && way[(axis + 2) % 3] == 0) triangle.b[(axis + 1) % 3] += 5;
    const glm::dvec3 on_edge = exactly_on_the_rim(random, triangle);
    return looked_at_exactly(random, triangle,
                             random.one_in(2) ? on_edge : eighth_between(random, on_edge, triangle.c));
  }
};

struct Far {
  static constexpr const char* name = "far";
  static constexpr const char* description =
      "the triangle is 1e2 to 1e6 sizes away, half the time aimed near an edge";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Triangle<double> triangle = in_a_room(random, 1);
    Scene scene;
    const glm::dvec3 target =
        random.one_in(2) ? on_the_rim(random, triangle) : in_or_beside(random, triangle);
    look_from_afar(random, scene, target, 1);
    scene.shape = triangle;
    return scene;
  }
};

struct Degenerate {
  static constexpr const char* name = "degenerate";
  static constexpr const char* description =
      "no area: vertices in a line, or two or three of them in one point; also almost so";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const glm::dvec3 a = whole_point(random, 8);
    const glm::dvec3 way = whole_vector(random, 3);
    Triangle<double> triangle{a, a + double{1} * random.between(-2, 2) * way,
                              a + double{1} * random.between(-2, 2) * way};
    if (random.one_in(4)) {  // Rounding lifts the third vertex off the line by an ulp, if at all.
      triangle.a = point_in_a_room(random);
      triangle.b = point_in_a_room(random);
      triangle.c = triangle.a + random.uniform(-1, 2) * (triangle.b - triangle.a);
    }
    return looked_at_exactly(random, triangle, exactly_on_the_rim(random, triangle));
  }
};

struct Coplanar {
  static constexpr const char* name = "coplanar";
  static constexpr const char* description =
      "in whole numbers: the ray runs in the triangle's plane, or parallel to it";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Triangle<double> triangle = whole(random);
    const auto step = [&] { return double{1} * random.between(-2, 2); };
    const double beta = step(), gamma = step();
    Scene scene;
    scene.origin = at(triangle, beta, gamma);
    const double towards_c = random.one_in(2) ? 1 : 2;
    scene.direction = at(triangle, step(), towards_c) - triangle.a;
    if (random.one_in(3)) scene.origin += whole_vector(random, 2);
    scene.shape = triangle;
    return scene;
  }
};

struct NearCoplanar {
  static constexpr const char* name = "near_coplanar";
  static constexpr const char* description = "the ray comes in at 2^-4 to an ulp off the triangle's plane";

  [[nodiscard]] static Scene scene(Random& random, int digits) {
    const Triangle<double> triangle = in_a_room(random);
    const glm::dvec3 in_plane = inside(random, triangle) - triangle.a;
    const glm::dvec3 any_way = draw::unit_vector(random);
    const glm::dvec3 slope = draw::magnitude<double>(random, -digits, -4) * any_way;
    const double length = std::sqrt(dot(in_plane, in_plane));
    Scene scene;
    const double distance = random.uniform(0, 20);
    look_at(scene, in_or_beside(random, triangle), 1 / length * in_plane + slope, distance, 1);
    scene.shape = triangle;
    return scene;
  }
};

}  // namespace rayproof::triangle_family
