#pragma once
/// \file
/// Scenes under an affine map: translated, turned, mirrored, sheared, stretched up to a condition of 1e6.

#include <glm/matrix.hpp>

#include "generators/aim.hpp"

namespace rayproof {

/// A rotation: three unit vectors at right angles.
[[nodiscard]] inline glm::dmat3 rotation(Random& random) {
  const glm::dvec3 x = draw::unit_vector(random);
  const glm::dvec3 y = draw::perpendicular(random, x);
  return {x, y, glm::cross(x, y)};
}

/// A stretch by factors of which the greatest is `condition` times the least; mirrored half the time.
[[nodiscard]] inline glm::dmat3 stretch(Random& random, double condition) {
  const double middle = std::exp(random.uniform(0, std::log(condition)));
  const double mirror = random.one_in(2) ? -1 : 1;
  const double size = std::exp2(random.uniform(-2, 2)) / std::sqrt(condition);
  return {glm::dvec3(mirror * size, 0, 0), glm::dvec3(0, middle * size, 0),
          glm::dvec3(0, 0, condition * size)};
}

/// The identity, a rotation, a shear, a stretch, or all of them.
[[nodiscard]] inline glm::dmat3 linear_part(Random& random) {
  const int kind = random.between(0, 4);
  if (kind == 0) return glm::dmat3(1);
  if (kind == 1) return rotation(random);
  if (kind == 2) {
    glm::dmat3 shear(1);
    shear[random.between(1, 2)][0] = random.uniform(-10, 10);
    return shear;
  }
  if (kind == 3) return stretch(random, std::pow(10, random.uniform(0, 2)));
  const glm::dmat3 first = rotation(random);
  const glm::dmat3 second = stretch(random, std::pow(10, random.uniform(0, 6)));
  return rotation(random) * second * first;
}

/// Moves a scene that was laid out in the shape's own space into the world: the ray goes along, t stays.
inline void move_by(Scene& scene, const glm::dmat3& linear, const glm::dvec3& moved_by) {
  scene.origin = linear * scene.origin + moved_by;
  scene.direction = linear * scene.direction;
  glm::dmat4 whole(linear);
  whole[3] = glm::dvec4(moved_by, 1);
  scene.transform = whole;
}

/// The same by any map.
inline void move_into_the_world(Random& random, Precision /*precision*/, Scene& scene) {
  const glm::dmat3 linear = linear_part(random);
  move_by(scene, linear, point_in_a_room(random));
}

/// The same by a map of small whole numbers, which rounds nothing in a scene of short numbers.
inline void move_exactly(Random& random, Precision /*precision*/, Scene& scene) {
  const auto whole = [&] { return whole_point(random, 2); };
  glm::dmat3 linear(0);
  while (glm::determinant(linear) == 0) linear = {whole(), whole(), whole()};
  move_by(scene, linear, whole());
}

}  // namespace rayproof
