#pragma once
/// \file
/// Rays aimed at spheres of everyday sizes: at tangents, surfaces, insides, interval ends.

#include <algorithm>

#include "generators/aim.hpp"

namespace rayproof::sphere_family {

using Ball = Sphere<double>;

/// A sphere of a radius between 0.1 and 5 within a box 20 wide around the origin.
[[nodiscard]] inline Ball in_a_room(Random& random) {
  const glm::dvec3 center = point_in_a_room(random);
  return {center, random.uniform(0.1, 5)};
}

/// A point within 1.6 radii of the centre: about half the rays to it hit.
[[nodiscard]] inline glm::dvec3 in_or_beside(Random& random, const Ball& ball) {
  const glm::dvec3 n = draw::unit_vector(random);
  return ball.center + ball.radius * random.uniform(0, 1.6) * n;
}

[[nodiscard]] inline Scene everyday(Random& random) {
  const Ball ball = in_a_room(random);
  return loosened(random, looked_at(random, ball, in_or_beside(random, ball)));
}

/// A sphere at the origin of its own space or near it, to be moved by a map.
[[nodiscard]] inline Scene near_its_origin(Random& random) {
  Ball ball{{}, random.one_in(2) ? 1 : random.uniform(0.1, 5)};
  if (random.one_in(2)) ball.center = point_in_a_room(random, 2);
  return looked_at(random, ball, in_or_beside(random, ball), 10);
}

/// An exact tangent: a whole-number rotation matrix times its own length N keeps everything whole.
[[nodiscard]] inline Scene tangent(Random& random) {
  int w = 0, x = 0, y = 0, z = 0;
  while (w == 0 && x == 0 && y == 0 && z == 0) {
    w = random.between(-3, 3), x = random.between(-3, 3), y = random.between(-3, 3),
    z = random.between(-3, 3);
  }
  const glm::dvec3 n(w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y));
  const glm::dvec3 sight(2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x));
  const Ball ball{whole_point(random, 20), double{1} * (w * w + x * x + y * y + z * z)};
  return looked_at(ball, ball.center + n, sight, random.between(0, 9), 1);
}

/// Across the unit vector `n`, past the centre at `share` radii.
[[nodiscard]] inline Scene looked_past(Random& random, const Ball& ball, const glm::dvec3& n, double share,
                                       double distance, double length) {
  return looked_at(ball, ball.center + ball.radius * share * n, draw::perpendicular(random, n), distance,
                   length);
}

[[nodiscard]] inline Scene grazing(Random& random, Precision precision) {
  if (random.one_in(6)) return tangent(random);
  const Ball ball = in_a_room(random);
  const glm::dvec3 n = draw::unit_vector(random);
  const double few_ulps = draw::digits_of(precision) - 2;
  const double beside = draw::magnitude<double>(random, -few_ulps, -10);
  const double length = direction_length(random), distance = random.uniform(0, 20);
  return looked_past(random, ball, n, 1 + beside, distance, length);
}

[[nodiscard]] inline Scene surface(Random& random, Precision precision) {
  const Ball ball = in_a_room(random);
  glm::dvec3 origin = ball.center + ball.radius * draw::unit_vector(random);
  for (int axis = 0; axis < 3; ++axis)
    origin[axis] = draw::nudged(precision, origin[axis], random.between(-2, 2));
  return {origin, any_direction(random), ball};
}

[[nodiscard]] inline Scene inside(Random& random) {
  const Ball ball = in_a_room(random);
  const double share = random.one_in(16) ? 0 : random.uniform(0, 0.999);
  return {ball.center + ball.radius * share * draw::unit_vector(random), any_direction(random), ball};
}

/// The interval ends at one of the hits, or a few ulps beside.
[[nodiscard]] inline Scene interval(Random& random, Precision precision) {
  const Ball ball = in_a_room(random);
  const glm::dvec3 n = draw::unit_vector(random);
  const double length = direction_length(random);
  const double distance = random.uniform(0, 20);
  const double beside = random.uniform(0, 0.999);
  Scene scene = looked_past(random, ball, n, beside, distance, length);
  const double half_chord = ball.radius * std::sqrt(1 - beside * beside);
  const double t0 = at_or_beside(random, precision, (distance - half_chord) / length);
  const double t1 = at_or_beside(random, precision, (distance + half_chord) / length);
  const int kind = random.between(0, 3);
  scene.t_min = kind == 0 ? t1 : kind == 1 ? 0 : t0;
  if (kind == 1) scene.t_max = std::max(t0, 0.0);
  if (kind == 2) scene.t_max = t1;
  if (scene.t_max < scene.t_min) std::swap(scene.t_min, scene.t_max);
  return scene;
}

}  // namespace rayproof::sphere_family
