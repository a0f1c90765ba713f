#pragma once
/// \file
/// Families aimed at a solid's edges, corners and faces, and the everyday case beside them. `Kind` is Boxes
/// or Oblique.

#include "generators/shapes/solid/scenes.hpp"

namespace rayproof::solid_family {

struct EverydayText {
  static constexpr const char* name = "random";
  static constexpr const char* description = "a solid in a room, about half the rays hit";
};
template <class Kind>
struct Everyday : EverydayText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = Kind::in_a_room(random);
    const glm::dvec3 target = at(frame, draw::vector([&] { return random.uniform(-0.3, 1.3); }));
    Scene scene = looked_at(random, Kind::shape(frame), target);
    loosen(random, scene);
    return scene;
  }
};

struct EdgesText {
  static constexpr const char* name = "edges";
  static constexpr const char* description =
      "in whole numbers: the line passes exactly through an edge or a corner";
};
template <class Kind>
struct Edges : EdgesText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = Kind::whole(random);
    return looked_at_exactly(random, Kind::shape(frame),
                             at(frame, exact_place(random, random.between(2, 3))));
  }
};

struct NearEdgesText {
  static constexpr const char* name = "near_edges";
  static constexpr const char* description = "the line passes an ulp or so from an edge or a corner";
};
template <class Kind>
struct NearEdges : NearEdgesText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = Kind::in_a_room(random);
    return looked_at(random, Kind::shape(frame), at(frame, place(random, random.one_in(4) ? 3 : 2)));
  }
};

struct InFacesText {
  static constexpr const char* name = "in_faces";
  static constexpr const char* description =
      "in whole numbers: the ray runs in the plane of a face or along an edge";
};
template <class Kind>
struct InFaces : InFacesText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Frame frame = Kind::whole(random);
    const int across = random.between(0, 2);  // the axis the ray does not move along
    glm::dvec3 start = draw::vector([&] { return random.between(-2, 6) / 4.0; }), way(0);
    start[across] = random.between(0, 1);
    const int other = (across + random.between(1, 2)) % 3;
    way[other] = random.one_in(2) ? 1 : -1;
    if (random.one_in(2)) way[3 - across - other] = random.between(-2, 2);
    Scene scene;
    scene.origin = at(frame, start);
    scene.direction = along(frame, way);
    if (random.one_in(4)) scene.t_min = -std::numeric_limits<double>::infinity();
    scene.shape = Kind::shape(frame);
    return scene;
  }
};

struct SurfaceText {
  static constexpr const char* name = "surface";
  static constexpr const char* description =
      "the origin lies on a face, an edge or a corner, or an ulp off, as secondary rays' do";
};
template <class Kind>
struct Surface : SurfaceText {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(2);
    const Frame frame = exactly ? Kind::whole(random) : Kind::in_a_room(random);
    const int at_an_end = random.one_in(2) ? 1 : random.between(2, 3);
    Scene scene;
    scene.origin = at(frame, exactly ? exact_place(random, at_an_end) : place(random, at_an_end));
    scene.direction = random.one_in(3) ? whole_vector(random, 3) : any_direction(random);
    scene.shape = Kind::shape(frame);
    return scene;
  }
};

/// For the interval: aimed at a face.
template <class Kind>
struct Faces {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const bool exactly = random.one_in(2);
    const Frame frame = exactly ? Kind::whole(random) : Kind::in_a_room(random);
    return exactly ? looked_at_exactly(random, Kind::shape(frame), at(frame, exact_place(random, 1)))
                   : looked_at(random, Kind::shape(frame), at(frame, place(random, 1)));
  }
};

}  // namespace rayproof::solid_family
