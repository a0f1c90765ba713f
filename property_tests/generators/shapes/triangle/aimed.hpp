#pragma once
/// \file
/// Triangle families aimed at edges and vertices, and the everyday case beside them.

#include "generators/shapes/triangle/scenes.hpp"

namespace rayproof::triangle_family {

struct Everyday {
  static constexpr const char* name = "random";
  static constexpr const char* description = "a triangle in a room, about half the rays hit";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Triangle<double> triangle = in_a_room(random);
    Scene scene = looked_at(random, triangle, in_or_beside(random, triangle));
    loosen(random, scene);
    return scene;
  }
};

struct Edges {
  static constexpr const char* name = "edges";
  static constexpr const char* description =
      "in whole numbers: the line passes exactly through an edge or a vertex";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Triangle<double> triangle = whole(random);
    return looked_at_exactly(random, triangle, exactly_on_the_rim(random, triangle));
  }
};

struct NearEdges {
  static constexpr const char* name = "near_edges";
  static constexpr const char* description = "the line passes an ulp or so from an edge or a vertex";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Triangle<double> triangle = in_a_room(random);
    return looked_at(random, triangle, on_the_rim(random, triangle));
  }
};

struct Fans {
  static constexpr const char* name = "fans";
  static constexpr const char* description =
      "one of a fan's triangles; the ray passes exactly through the hub or a shared edge";

  /// A vector of short numbers that are no whole ones: sums and eighths of them are exact.
  [[nodiscard]] static glm::dvec3 short_vector(Random& random) {
    return 1 / 64.0 * whole_vector(random, 512);
  }

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const glm::dvec3 hub = short_vector(random), first = hub + short_vector(random);
    const Triangle<double> triangle{hub, first, hub + short_vector(random)};
    Scene scene;
    const glm::dvec3 target = random.one_in(2) ? hub : eighth_between(random, hub, first);
    look_exactly(random, scene, target, short_vector(random));
    scene.shape = triangle;
    return scene;
  }
};

struct Cut {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(3);
    const Triangle<double> triangle = exactly ? whole(random) : in_a_room(random);
    return exactly ? looked_at_exactly(random, triangle, at(triangle, 0.25, random.between(0, 3) / 4.0))
                   : looked_at(random, triangle, inside(random, triangle));
  }
};

}  // namespace rayproof::triangle_family
