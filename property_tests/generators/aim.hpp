#pragma once
/// \file
/// Rays aimed at a point: in rounded numbers, which pass it by an ulp, and in whole ones, which pass through
/// it exactly.

#include <glm/geometric.hpp>

#include "generators/scene.hpp"

namespace rayproof {

/// The length of a direction: often 1, otherwise between 1/8 and 8.
[[nodiscard]] inline double direction_length(Random& random) {
  return random.one_in(2) ? 1 : std::exp2(random.uniform(-3, 3));
}

/// A direction, any one as likely as every other.
[[nodiscard]] inline glm::dvec3 any_direction(Random& random) {
  const glm::dvec3 sight = draw::unit_vector(random);
  return direction_length(random) * sight;
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

/// A point on the segment from `a` to `b`, at an eighth of the way or one of the ends: exact for whole ends.
[[nodiscard]] inline glm::dvec3 eighth_between(Random& random, const glm::dvec3& a, const glm::dvec3& b) {
  return a + (random.between(0, 8) / 8.0) * (b - a);
}

/// A plane as a generator works on it: all point + a·u + b·v.
using Sheet = ParametricPlane;

[[nodiscard]] inline glm::dvec3 at(const Sheet& sheet, const Vec2<double>& ab) {
  return sheet.point + ab.x * sheet.u + ab.y * sheet.v;
}

/// `t` to the nearest number of the precision, or, half the time, a few ulps beside it.
[[nodiscard]] inline double at_or_beside(Random& random, Precision precision, double t) {
  return draw::nudged(precision, t, random.one_in(2) ? 0 : random.between(-3, 3));
}

/// A shape seen from `distance` away from `target`, along `sight` (a unit vector) and with a direction
/// `length` long.
[[nodiscard]] inline Scene looked_at(const Shape& shape, const glm::dvec3& target, const glm::dvec3& sight,
                                     double distance, double length) {
  return {target - distance * sight, length * sight, shape, distance / length};
}

/// Along `sight` from anywhere within 20 of the target.
[[nodiscard]] inline Scene looked_along(Random& random, const Shape& shape, const glm::dvec3& target,
                                        const glm::dvec3& sight) {
  const double length = direction_length(random), distance = random.uniform(0, 20);
  return looked_at(shape, target, sight, distance, length);
}

/// Along any direction from anywhere within `farthest` of the target.
[[nodiscard]] inline Scene looked_at(Random& random, const Shape& shape, const glm::dvec3& target,
                                     double farthest = 20) {
  const double length = direction_length(random), distance = random.uniform(0, farthest);
  return looked_at(shape, target, draw::unit_vector(random), distance, length);
}

/// From 1e2 to 1e6 away.
[[nodiscard]] inline Scene looked_at_from_afar(Random& random, const Shape& shape, const glm::dvec3& target) {
  const double length = direction_length(random), distance = std::pow(10, random.uniform(2, 6));
  return looked_at(shape, target, draw::unit_vector(random), distance, length);
}

/// Along `sight` from whole steps away, so that no number is rounded.
[[nodiscard]] inline Scene looked_at_exactly(Random& random, const Shape& shape, const glm::dvec3& target,
                                             const glm::dvec3& sight) {
  const double steps = random.between(0, 7);
  const double length = std::exp2(random.one_in(2) ? 0 : random.between(-3, 3));
  return looked_at(shape, target, sight, steps, length);
}

/// The same along a whole vector.
[[nodiscard]] inline Scene looked_at_exactly(Random& random, const Shape& shape, const glm::dvec3& target) {
  return looked_at_exactly(random, shape, target, whole_vector(random, 4));
}

/// A short whole vector, or one whose every digit counts: what is rounded on the way differs.
[[nodiscard]] inline glm::dvec3 toward_the_horizon(Random& random) {
  return random.one_in(2) ? whole_vector(random, 4) : draw::unit_vector(random);
}

/// From where a ray along the vector passes exactly through (0, 0, 0): 2^(0.8·digits) to 2^(2.2·digits) steps
/// before it.
[[nodiscard]] inline glm::dvec3 horizon(Random& random, Precision precision, const glm::dvec3& direction) {
  return -std::exp2(std::floor(random.uniform(0.8, 2.2) * draw::digits_of(precision))) * direction;
}
inline constexpr const char* horizon_description =
    "from 2^(0.6·digits) sizes away, or exactly at (0, 0, 0), near the boundary, from up to 2^(2.2·digits)";

/// Half the time moved aside by a small step: a tolerance shows beside what the ray was aimed at.
[[nodiscard]] inline Scene maybe_aside(Random& random, Precision precision, Scene scene) {
  if (random.one_in(2)) return scene;
  const glm::dvec3 aside = draw::perpendicular(random, glm::normalize(scene.direction));
  scene.origin += draw::small_step(random, precision) * aside;
  return scene;
}

/// A fifth of the rays turned round, and a quarter made whole lines.
[[nodiscard]] inline Scene loosened(Random& random, Scene scene) {
  if (random.one_in(5)) scene.direction = -scene.direction;
  if (random.one_in(4)) scene.t_min = -std::numeric_limits<double>::infinity();
  return scene;
}

/// Moves a shape that is given by points.
inline void move(Shape& given, const glm::dvec3& by) {
  const auto move = [&by](const char* /*name*/, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, glm::dvec3>) value += by;
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::vector<glm::dvec3>>)
      for (glm::dvec3& place : value) place += by;
  };
  std::visit([&move]<class S>(S& shape) { ShapeFormat<S>::fields(shape, move); }, given);
}
/// The scene moved by 1e2 to 1e4, so that its numbers lose digits.
[[nodiscard]] inline Scene displaced(Random& random, Scene scene) {
  const glm::dvec3 by = std::pow(10, random.uniform(2, 4)) * draw::unit_vector(random);
  scene.origin += by;
  move(scene.shape, by);
  return scene;
}
inline constexpr const char* displaced_description =
    "1e2 to 1e4 from the origin of coordinates: the ray passes near the boundary";

}  // namespace rayproof
