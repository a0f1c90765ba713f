#pragma once
/// \file
/// Cylinders met at the end of an axis of their ellipse, or at a rim there, at a t that is known to a bit,
/// and missed by next to nothing. What has too many digits for one number is the difference of a radius, or
/// the height, and the origin's coordinate.

#include "generators/lattice.hpp"
#include "generators/shapes/cylinder/scenes.hpp"

namespace rayproof::cylinder_family {

/// The ray leaves the side at t = M·2^(e - digits), but for small steps: aside, along the ray, or in height.
/// At `rim` it does so where the cylinder ends.
[[nodiscard]] inline Scene hard_at_the_side(Random& random, Precision precision, bool at_rim) {
  const int digits = draw::digits_of(precision), bits = 3 * digits, e = random.between(0, 3);
  const bool ends_there = !at_rim && random.one_in(3);
  const lattice::Whole half = lattice::some_whole(random, digits), M = 2 * half + (ends_there ? 0 : 1);
  const lattice::Whole t = M << (bits - digits + e);
  const auto step = [&](double least, double most) {
    const double size = std::exp2(-std::floor(random.uniform(least, most) * digits)) * random.between(1, 7);
    return random.one_in(3) ? 0 : random.one_in(2) ? size : -size;
  };
  const auto [radius, x] = lattice::difference(precision, t + lattice::whole(step(1.4, 1.9), bits), bits);
  const int slope = random.between(1, 3);
  const auto [height, z] =
      lattice::difference(precision, slope * t + lattice::whole(step(1.4, 1.9), bits), bits);

  Tube tube{radius, random.uniform(0.5, 5), height, random.one_in(2)};
  Scene scene{{x, step(0.7, 1.3), z}, {1, 0, slope}, tube, lattice::number(M, digits - e)};
  if (!at_rim) {  // somewhere between the ends
    tube.height = random.uniform(1, 20);
    scene.direction.z = random.between(-2, 2);
    scene.origin.z = tube.height * random.unit() - scene.aimed_at * scene.direction.z;
  }
  if (ends_there) (random.one_in(2) ? scene.t_min : scene.t_max) = scene.aimed_at;
  if (random.one_in(2)) {
    std::swap(tube.rx, tube.ry);
    std::swap(scene.origin.x, scene.origin.y);
    std::swap(scene.direction.x, scene.direction.y);
  }
  if (random.one_in(2)) {
    scene.origin.x = -scene.origin.x;
    scene.direction.x = -scene.direction.x;
  }
  scene.shape = tube;
  return scene;
}

[[nodiscard]] inline Scene hard_to_round(Random& random, Precision precision) {
  return hard_at_the_side(random, precision, false);
}
[[nodiscard]] inline Scene hard_to_decide(Random& random, Precision precision) {
  return hard_at_the_side(random, precision, true);
}

}  // namespace rayproof::cylinder_family
