#pragma once
/// \file
/// Cylinders with radii of powers of two, and rays through the ends of their axes and diagonals, where what
/// is divided by the radii, and the chords, are short numbers.

#include "generators/shapes/cylinder/scenes.hpp"
#include "generators/whole.hpp"

namespace rayproof::cylinder_family {

[[nodiscard]] inline Tube short_tube(Random& random) {
  const double rx = std::exp2(random.between(-1, 2)), ry = std::exp2(random.between(-1, 2));
  return {rx, ry, random.one_in(6) ? 0 : std::exp2(random.between(-1, 2)), random.one_in(2)};
}

/// One of the four turns at which the unit circle has whole coordinates.
[[nodiscard]] inline Turn quarter_turn(Random& random) {
  const double sign = random.one_in(2) ? 1 : -1;
  return random.one_in(2) ? Turn{sign, 0} : Turn{0, sign};
}

/// Aimed at the side, at a rim, at an end inside the side or outside, or at the plane of an end beyond it;
/// along the axis of z, an axis of the ellipse, its diagonals, or obliquely.
[[nodiscard]] inline Scene whole_numbers(Random& random) {
  const Tube tube = short_tube(random);
  const Turn turn = quarter_turn(random);
  const double share = random.one_in(2) ? 1 : quarters(random, 0, 2);
  const bool at_an_end = random.one_in(2), between_ends = random.one_in(2);
  const double z = at_an_end
                       ? some_end(random, tube)
                       : tube.height * (between_ends ? quarters(random, 0, 1) : quarters(random, -1, 2));
  const int kind = random.between(0, 5);
  const Turn other = quarter_turn(random);
  const double x = kind == 0 ? 0 : kind == 1 ? other.cosine - turn.cosine : other.cosine;
  const double y = kind == 0 ? 0 : kind == 1 ? other.sine - turn.sine : other.sine;
  glm::dvec3 sight(tube.rx * x, tube.ry * y, random.one_in(3) ? 0 : random.between(-2, 2));
  if (sight == glm::dvec3(0)) sight.z = 1;
  return looked_at_exactly(random, tube, at(tube, turn, share, z), sight);
}

}  // namespace rayproof::cylinder_family
