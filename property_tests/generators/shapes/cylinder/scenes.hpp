#pragma once
/// \file
/// Elliptic cylinders to aim at, in rounded numbers and in whole ones.

#include <glm/common.hpp>
#include <numbers>

#include "generators/aim.hpp"

namespace rayproof::cylinder_family {

using Tube = Cylinder<double>;

/// A place on the side's ellipse: the cosine and the sine of its parameter.
struct Turn {
  double cosine, sine;
};

[[nodiscard]] inline Turn any_turn(Random& random) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

/// A turn of fifths: its place on an ellipse of radii that are multiples of 5 is whole.
[[nodiscard]] inline Turn whole_turn(Random& random) {
  const bool along_an_axis = random.one_in(3);
  const double p = (along_an_axis ? 5 : 3) / 5.0, q = (along_an_axis ? 0 : 4) / 5.0;
  const double x = random.one_in(2) ? p : -p, y = random.one_in(2) ? q : -q;
  return random.one_in(2) ? Turn{x, y} : Turn{y, x};
}

/// The point at `share` of the way from the axis to the side, at height z.
[[nodiscard]] inline glm::dvec3 at(const Tube& tube, const Turn& turn, double share, double z) {
  return {tube.rx * share * turn.cosine, tube.ry * share * turn.sine, z};
}

/// The horizontal direction in which the ellipse runs there.
[[nodiscard]] inline glm::dvec3 tangent(const Tube& tube, const Turn& turn) {
  return {-tube.rx * turn.sine, tube.ry * turn.cosine, 0};
}

[[nodiscard]] inline Tube in_a_room(Random& random) {
  const double rx = random.uniform(0.5, 5), ry = random.one_in(4) ? rx : random.uniform(0.5, 5);
  return {rx, ry, random.uniform(0.5, 5), random.one_in(2)};
}

/// A cylinder of whole numbers, its radii multiples of 5.
[[nodiscard]] inline Tube whole(Random& random) {
  const double rx = 5 * random.between(1, 3), ry = 5 * random.between(1, 3);
  return {rx, ry, double{1} * random.between(1, 8), random.one_in(2)};
}

/// `at` the side without the rounding of fifths.
[[nodiscard]] inline glm::dvec3 exactly_at(const Tube& tube, const Turn& turn, double z) {
  glm::dvec3 place = glm::round(at(tube, turn, 1, 0));
  place.z = z;
  return place;
}

[[nodiscard]] inline double some_end(Random& random, const Tube& tube) {
  return random.one_in(2) ? 0 : tube.height;
}

}  // namespace rayproof::cylinder_family
