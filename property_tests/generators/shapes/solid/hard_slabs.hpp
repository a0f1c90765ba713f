#pragma once
/// \file
/// Rays from next to the origin of coordinates at boxes, whose quotients are beside each other or beside the
/// middle of two numbers by what the origin's tiny coordinates make up. (From elsewhere the differences of
/// floats are exact in double, and their quotients never that near.)

#include "generators/hard_to_round.hpp"
#include "generators/shapes/solid/scenes.hpp"

namespace rayproof::solid_family {

/// An odd number with this number of bits.
[[nodiscard]] inline lattice::Whole odd(Random& random, int bits) {
  return lattice::some_whole(random, bits) | 1;
}

/// A number next to 1, or 1.
[[nodiscard]] inline double next_to_one(Random& random, int digits) {
  return random.one_in(8) ? 1 : 1 + draw::magnitude<double>(random, -digits, -1);
}

/// A wide box of which the ray enters one slab at t = p / d, half the time as it leaves another.
[[nodiscard]] inline std::optional<Scene> hard_slabs(Random& random, const hard::Grid& grid) {
  using lattice::Whole, lattice::number;
  const int q = grid.digits, i = random.between(0, 2), j = (i + random.between(1, 2)) % 3;
  const bool is_edge = random.one_in(2);
  Scene scene{{}, {0, 0, 0}, {}};
  Box<double> box{glm::dvec3(-64), glm::dvec3(64)};
  scene.direction[3 - i - j] = random.uniform(-1, 1);

  const Whole d = odd(random, q), r = odd(random, random.between(1, q / 2));
  scene.direction[i] = number(d, q);
  if (is_edge) {  // p·d' - p'·d = r, and so much do o and o' take away
    const Whole other = odd(random, q);
    if (gcd(d, other) != 1) return std::nullopt;
    const Whole p = lattice::quotient_modulo(r, other, d), q_of_other = (p * other - r) / d;
    if (q_of_other <= 0) return std::nullopt;
    box.min[i] = number(p, q - 3);
    box.max[j] = number(q_of_other, q - 3);
    scene.direction[j] = number(other, q);
    scene.origin[j] = random.uniform(-1, 1) * number(r, 2 * q - 3);
    const double taken = number(r, 2 * q - 3) * next_to_one(random, q);
    scene.origin[i] = (taken + scene.origin[j] * scene.direction[i]) / scene.direction[j];
  } else {  // p·2^(q + 1) = M·d + r for an M between two numbers
    const Whole p = lattice::quotient_modulo(r, Whole(1) << (q + 1), d);
    if (2 * p < d) return std::nullopt;
    box.min[i] = number(p, q - 3);
    scene.origin[i] = number(r, 2 * q - 2) * next_to_one(random, q);
  }
  for (const int axis : {i, j})
    if (random.one_in(2)) {
      scene.origin[axis] = -scene.origin[axis];
      scene.direction[axis] = -scene.direction[axis];
      std::swap(box.min[axis] = -box.min[axis], box.max[axis] = -box.max[axis]);
    }
  scene.shape = box;
  return scene;
}

}  // namespace rayproof::solid_family
