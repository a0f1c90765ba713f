#pragma once
/// \file
/// Disks in rooms, and rays aimed at them: within and beside, at the rim, in the plane.

#include "generators/aim.hpp"

namespace rayproof::disk_family {

/// A disk in a room, of radius 1/4 to 4.
[[nodiscard]] inline Disk<double> in_a_room(Random& random) {
  const glm::dvec3 center = point_in_a_room(random);
  const glm::dvec3 normal = draw::unit_vector(random);
  const double length = std::exp2(random.uniform(-2, 2));
  return {center, length * normal, std::exp2(random.uniform(-2, 2))};
}

/// A point of the disk's plane, `part` of the radius from the centre.
[[nodiscard]] inline glm::dvec3 at(Random& random, const Disk<double>& disk, double part) {
  const glm::dvec3 n = (1 / std::sqrt(dot(disk.normal, disk.normal))) * disk.normal;
  return disk.center + part * disk.radius * draw::perpendicular(random, n);
}

[[nodiscard]] inline Scene everyday(Random& random) {
  const Disk<double> disk = in_a_room(random);
  const double part = random.uniform(0, 1.5);
  const Scene scene = looked_at(random, disk, at(random, disk, part));
  return random.one_in(2) ? loosened(random, scene) : scene;
}

[[nodiscard]] inline Scene near_rim(Random& random, Precision precision) {
  const Disk<double> disk = in_a_room(random);
  const double part = 1 + draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  return looked_at(random, disk, at(random, disk, part));
}

/// Disks across the x, y or z axis: (3, 4) and its like are whole points of a rim.
[[nodiscard]] inline Scene rim(Random& random) {
  const int axis = random.between(0, 2);
  const double size = random.between(1, 3);
  Disk<double> disk{whole_point(random, 8), {}, 5 * size};
  disk.normal[axis] = random.one_in(2) ? 2 : -1;
  glm::dvec3 spoke{};
  const bool is_steep = random.one_in(2);
  spoke[(axis + 1) % 3] = size * (is_steep ? 3 : -4);
  spoke[(axis + 2) % 3] = size * (is_steep ? 4 : 3);
  const double part = random.one_in(2) ? 1 : random.between(0, 4) / 2.0;
  Scene scene = looked_at_exactly(random, disk, disk.center + part * spoke);
  if (random.one_in(8)) scene.direction[axis] = 0;
  if (scene.direction == glm::dvec3(0)) scene.direction = spoke;
  return scene;
}

}  // namespace rayproof::disk_family
