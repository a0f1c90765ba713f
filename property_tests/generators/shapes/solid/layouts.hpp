#pragma once
/// \file
/// Rays aimed at solids: at faces, edges and corners, along them, from inside and from afar. `Kind` is Boxes
/// or Oblique.

#include "generators/shapes/solid/scenes.hpp"

namespace rayproof::solid_family {

template <class Kind>
[[nodiscard]] Scene everyday(Random& random) {
  const Frame frame = Kind::in_a_room(random);
  const glm::dvec3 target = at(frame, draw::vector([&] { return random.uniform(-0.3, 1.3); }));
  return loosened(random, looked_at(random, Kind::shape(frame), target));
}

template <class Kind>
[[nodiscard]] Scene edges(Random& random) {
  const Frame frame = Kind::whole(random);
  return looked_at_exactly(random, Kind::shape(frame), at(frame, exact_place(random, random.between(2, 3))));
}

template <class Kind>
[[nodiscard]] Scene near_edges(Random& random) {
  const Frame frame = Kind::in_a_room(random);
  return looked_at(random, Kind::shape(frame), at(frame, place(random, random.one_in(4) ? 3 : 2)));
}

/// For the interval: aimed at a face.
template <class Kind>
[[nodiscard]] Scene faces(Random& random) {
  const bool exactly = random.one_in(2);
  const Frame frame = exactly ? Kind::whole(random) : Kind::in_a_room(random);
  return exactly ? looked_at_exactly(random, Kind::shape(frame), at(frame, exact_place(random, 1)))
                 : looked_at(random, Kind::shape(frame), at(frame, place(random, 1)));
}

template <class Kind>
[[nodiscard]] Scene in_faces(Random& random) {
  const Frame frame = Kind::whole(random);
  const int across = random.between(0, 2);  // the axis the ray does not move along
  glm::dvec3 start = draw::vector([&] { return random.between(-2, 6) / 4.0; }), direction(0);
  start[across] = random.between(0, 1);
  const int other = (across + random.between(1, 2)) % 3;
  direction[other] = random.one_in(2) ? 1 : -1;
  if (random.one_in(2)) direction[3 - across - other] = random.between(-2, 2);
  Scene scene{at(frame, start), along(frame, direction), Kind::shape(frame)};
  if (random.one_in(4)) scene.t_min = -std::numeric_limits<double>::infinity();
  return scene;
}

/// Whole a third of the time.
[[nodiscard]] inline glm::dvec3 some_direction(Random& random) {
  return random.one_in(3) ? whole_vector(random, 3) : any_direction(random);
}

template <class Kind>
[[nodiscard]] Scene surface(Random& random) {
  const bool exactly = random.one_in(2);
  const Frame frame = exactly ? Kind::whole(random) : Kind::in_a_room(random);
  const int at_an_end = random.one_in(2) ? 1 : random.between(2, 3);
  return {at(frame, exactly ? exact_place(random, at_an_end) : place(random, at_an_end)),
          some_direction(random), Kind::shape(frame)};
}

template <class Kind>
[[nodiscard]] Scene inside(Random& random) {
  const Frame frame = Kind::in_a_room(random);
  return {at(frame, draw::vector([&] { return random.uniform(0.001, 0.999); })), some_direction(random),
          Kind::shape(frame)};
}

template <class Kind>
[[nodiscard]] Scene axis_parallel(Random& random) {
  const Frame frame = random.one_in(2) ? Kind::whole(random) : Kind::in_a_room(random);
  const auto anywhere = [&] { return random.uniform(-0.3, 1.3); };
  const glm::dvec3 target = at(frame, place(random, random.one_in(3) ? 1 : 0, anywhere));
  glm::dvec3 sight = draw::vector([&] { return draw::magnitude<double>(random, -2, 0); });
  const int first = random.between(0, 2);
  for (int k = random.between(1, 2); k > 0; --k) sight[(first + k) % 3] *= 0;
  return looked_along(random, Kind::shape(frame), target, sight);
}

template <class Kind>
[[nodiscard]] Scene flat(Random& random) {
  const Frame frame = Kind::flat(random);
  const glm::dvec3 target = at(frame, draw::vector([&] { return random.uniform(-0.2, 1.2); }));
  const glm::dvec3 sight = random.one_in(4) ? whole_vector(random, 1) : draw::unit_vector(random);
  return looked_along(random, Kind::shape(frame), target, sight);
}

template <class Kind>
[[nodiscard]] Scene far(Random& random) {
  const Frame frame = Kind::in_a_room(random);
  return looked_at_from_afar(random, Kind::shape(frame), at(frame, place(random, random.one_in(2) ? 2 : 0)));
}

}  // namespace rayproof::solid_family
