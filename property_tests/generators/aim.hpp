#pragma once
/// \file
/// Rays aimed at a point: in rounded numbers, which pass it by an ulp, and in whole ones, which pass through
/// it exactly.

#include "generators/scene.hpp"

namespace rayproof {

/// Puts the origin at `distance` from `target`, looking at it along `sight` (a unit vector), with a direction
/// `length` long.
inline void look_at(RayScene& scene, const glm::dvec3& target, const glm::dvec3& sight, double distance,
                    double length) {
  scene.origin = target - distance * sight;
  scene.direction = length * sight;
  scene.aimed_at = distance / length;
}

/// The length of a direction: often 1, otherwise between 1/8 and 8.
[[nodiscard]] inline double direction_length(Random& random) {
  return random.one_in(2) ? 1 : std::exp2(random.uniform(-3, 3));
}

/// A direction, any one as likely as every other.
[[nodiscard]] inline glm::dvec3 any_direction(Random& random) {
  const glm::dvec3 sight = draw::unit_vector(random);
  return direction_length(random) * sight;
}

/// Looks at `target` along `sight` from within `farthest` of it.
inline void look_along(Random& random, RayScene& scene, const glm::dvec3& target, const glm::dvec3& sight,
                       double farthest) {
  const double length = direction_length(random), distance = random.uniform(0, farthest);
  look_at(scene, target, sight, distance, length);
}

/// Looks at `target` from anywhere within 20 of it.
inline void look_at(Random& random, RayScene& scene, const glm::dvec3& target) {
  const double length = direction_length(random), distance = random.uniform(0, 20);
  look_at(scene, target, draw::unit_vector(random), distance, length);
}

/// Looks at `target` from 1e2 to 1e6 times `size` away.
inline void look_from_afar(Random& random, RayScene& scene, const glm::dvec3& target, double size) {
  const double length = direction_length(random), distance = size * std::pow(10, random.uniform(2, 6));
  look_at(scene, target, draw::unit_vector(random), distance, length);
}

/// Turns a fifth of the rays round and makes a quarter whole lines.
inline void loosen(Random& random, RayScene& scene) {
  if (random.one_in(5)) scene.direction = -scene.direction;
  if (random.one_in(4)) scene.t_min = -std::numeric_limits<double>::infinity();
}

/// A point of coordinates uniform in [-size, size].
[[nodiscard]] inline glm::dvec3 point_in_a_room(Random& random, double size = 10) {
  return draw::vector([&] { return random.uniform(-size, size); });
}

/// A point of whole coordinates in [-size, size].
[[nodiscard]] inline glm::dvec3 whole_point(Random& random, int size) {
  return draw::vector([&] { return double{1} * random.between(-size, size); });
}

/// A vector of whole coordinates in [-size, size], not zero; a third of them along an axis.
[[nodiscard]] inline glm::dvec3 whole_vector(Random& random, int size) {
  glm::dvec3 v{};
  if (random.one_in(3)) {
    const double sign = random.one_in(2) ? -1 : 1;  // beside it -0 where it is -1
    v = sign * v;
    v[random.between(0, 2)] = sign * random.between(1, size);
    return v;
  }
  while (v == glm::dvec3(0)) v = whole_point(random, size);
  return v;
}

/// Looks at `target` along `sight` from so many whole steps away that no number is rounded.
inline void look_exactly(Random& random, RayScene& scene, const glm::dvec3& target, const glm::dvec3& sight) {
  const double steps = random.between(0, 7);
  const double length = std::exp2(random.one_in(2) ? 0 : random.between(-3, 3));
  scene.origin = target - steps * sight;
  scene.direction = length * sight;
  scene.aimed_at = steps / length;
}

/// The same along a whole vector.
inline void look_exactly(Random& random, RayScene& scene, const glm::dvec3& target) {
  look_exactly(random, scene, target, whole_vector(random, 4));
}

/// A shape looked at, at `target` from anywhere within 20 of it.
[[nodiscard]] inline Scene looked_at(Random& random, const Shape& shape, const glm::dvec3& target) {
  Scene scene{{}, shape};
  look_at(random, scene, target);
  return scene;
}
/// The same from whole steps away, so that no number is rounded.
[[nodiscard]] inline Scene looked_at_exactly(Random& random, const Shape& shape, const glm::dvec3& target) {
  Scene scene{{}, shape};
  look_exactly(random, scene, target);
  return scene;
}

/// A point on the segment from `a` to `b`, at an eighth of the way or one of the ends: exact for whole ends.
[[nodiscard]] inline glm::dvec3 eighth_between(Random& random, const glm::dvec3& a, const glm::dvec3& b) {
  return a + (random.between(0, 8) / 8.0) * (b - a);
}

}  // namespace rayproof
