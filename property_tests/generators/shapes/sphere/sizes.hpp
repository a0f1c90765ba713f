#pragma once
/// \file
/// Spheres of unlike sizes: far away, tiny, huge, of any exponent, and an origin so near the surface that
/// b² >> 4ac.

#include "generators/shapes/sphere/aimed.hpp"

namespace rayproof::sphere_family {

/// An exponent that stays well inside the domain of every bounded contract (method/contract.hpp, Domain).
[[nodiscard]] constexpr double roomy_exponent(Precision precision) {
  return precision == Precision::float32 ? 24 : 200;
}

/// From `ratio` radii away, at a point within 1.1 radii of the centre, half the time near the limb.
[[nodiscard]] inline Scene seen_from(Random& random, const Ball& ball, double ratio) {
  const glm::dvec3 sight = draw::unit_vector(random);
  const double beside = random.one_in(2) ? random.uniform(0, 1.1) : random.uniform(0.99, 1.01);
  const glm::dvec3 target = ball.center + ball.radius * beside * draw::perpendicular(random, sight);
  return looked_at(ball, target, sight, ratio * ball.radius, direction_length(random));
}

[[nodiscard]] inline Scene far(Random& random) {
  Ball ball{{}, random.uniform(0.5, 2)};
  if (random.one_in(2)) ball.center = point_in_a_room(random);
  return seen_from(random, ball, std::pow(10, random.uniform(2, 6)));
}

[[nodiscard]] inline Scene tiny(Random& random, Precision precision) {
  const double roomy = roomy_exponent(precision);
  const double radius = std::exp2(random.uniform(-roomy, -roomy / 2));
  const Ball ball{draw::vector([&] { return radius * random.uniform(-10, 10); }), radius};
  return seen_from(random, ball, std::exp2(random.uniform(0, 6)));
}

[[nodiscard]] inline Scene huge(Random& random, Precision precision) {
  const double roomy = roomy_exponent(precision);
  Ball ball{{}, std::exp2(random.uniform(roomy / 2, roomy))};
  const double height = random.one_in(2) ? random.uniform(0, 2) * ball.radius : random.uniform(0, 100);
  const glm::dvec3 up = draw::unit_vector(random);
  glm::dvec3 origin = (ball.radius + height) * up;
  if (random.one_in(2)) {  // The planet's ground, not its centre, lies near the origin of coordinates.
    ball.center = -ball.radius * up;
    origin = height * up;
  }
  const glm::dvec3 sight = draw::unit_vector(random) - up;
  const glm::dvec3 direction = direction_length(random) * sight;
  return {origin, direction == glm::dvec3(0) ? -up : direction, ball};
}

[[nodiscard]] inline Scene cancelling(Random& random, Precision precision) {
  const Ball ball = in_a_room(random);
  const glm::dvec3 up = draw::unit_vector(random);
  const double height = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  const glm::dvec3 slant = 0.7 * draw::unit_vector(random);
  const glm::dvec3 sight = (random.one_in(2) ? 1.0 : -1.0) * up + slant;
  return {ball.center + ball.radius * (1 + height) * up, direction_length(random) * sight, ball};
}

[[nodiscard]] inline Scene exponents(Random& random, Precision precision) {
  const double size = draw::any_exponent(random, precision, 4);
  const double length = draw::any_exponent(random, precision, 4);
  const auto coordinate = [&] {
    return round_to(precision, draw::magnitude<double>(random, size - 3, size + 2));
  };
  const Ball ball{draw::vector(coordinate), std::abs(coordinate())};
  Scene scene{draw::vector(coordinate), {}, ball};
  // Aimed at a point of the ball's bounding box, so that about half the rays hit.
  const auto shift = static_cast<int>(std::floor(length - size));  // 2^shift itself may be no double
  for (int axis = 0; axis < 3; ++axis) {
    const double target = ball.center[axis] + ball.radius * draw::symmetric<double>(random);
    scene.direction[axis] = round_to(precision, std::ldexp(target - scene.origin[axis], shift));
  }
  if (scene.direction == glm::dvec3(0)) scene.direction.z = std::exp2(std::floor(length));
  return scene;
}

}  // namespace rayproof::sphere_family
