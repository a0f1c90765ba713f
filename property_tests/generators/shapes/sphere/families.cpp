/// \file
/// The families of spheres, and those of unlike sizes laid out: far away, tiny, huge, of any exponent, and an
/// origin so near the surface that b² >> 4ac.

#include "generators/hard_to_round.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/sphere/hard.hpp"

namespace rayproof {

namespace sphere_family {

/// An exponent that stays well inside the domain of every bounded contract (method/contract.hpp, Domain).
constexpr double roomy_exponent(Precision precision) { return precision == Precision::float32 ? 24 : 200; }

/// From `ratio` radii away, at a point within 1.1 radii of the centre, half the time near the limb.
Scene seen_from(Random& random, const Ball& ball, double ratio) {
  const glm::dvec3 sight = draw::unit_vector(random);
  const double beside = random.one_in(2) ? random.uniform(0, 1.1) : random.uniform(0.99, 1.01);
  const glm::dvec3 target = ball.center + ball.radius * beside * draw::perpendicular(random, sight);
  return looked_at(ball, target, sight, ratio * ball.radius, direction_length(random));
}

Scene far(Random& random) {
  Ball ball{{}, random.uniform(0.5, 2)};
  if (random.one_in(2)) ball.center = point_in_a_room(random);
  return seen_from(random, ball, std::pow(10, random.uniform(2, 6)));
}

Scene tiny(Random& random, Precision precision) {
  const double roomy = roomy_exponent(precision);
  const double radius = std::exp2(random.uniform(-roomy, -roomy / 2));
  const Ball ball{draw::vector([&] { return radius * random.uniform(-10, 10); }), radius};
  return seen_from(random, ball, std::exp2(random.uniform(0, 6)));
}

Scene huge(Random& random, Precision precision) {
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

Scene cancelling(Random& random, Precision precision) {
  const Ball ball = in_a_room(random);
  const glm::dvec3 up = draw::unit_vector(random);
  const double height = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  const glm::dvec3 slant = 0.7 * draw::unit_vector(random);
  const glm::dvec3 sight = (random.one_in(2) ? 1.0 : -1.0) * up + slant;
  return {ball.center + ball.radius * (1 + height) * up, direction_length(random) * sight, ball};
}

Scene exponents(Random& random, Precision precision) {
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

}  // namespace sphere_family

std::vector<Family> sphere_families() {
  using namespace sphere_family;
  const MinimumShare all_in_reach{"in reach", 1};
  return {
      laid_out<far>("far", "the sphere is 1e2 to 1e6 radii away",
                    {all_in_reach, {"hit", 0.4}, {"miss", 0.1}}),
      laid_out<everyday>("random", "a sphere in a room, about half the rays hit",
                         {all_in_reach, {"hit", 0.3}, {"miss", 0.2}, {"behind", 0.05}}),
      laid_out<grazing>("grazing", "the line passes the centre at r(1 ± a few ulps … 1e-3), or touches",
                        {all_in_reach, {"hit", 0.3}, {"miss", 0.2}, {"tangent", 0.05}}),
      laid_out<surface>("surface", "the origin lies on the surface or a few ulps off, as secondary rays' do",
                        {all_in_reach, {"hit", 0.3}, {"from inside", 0.2}}),
      laid_out<inside>("inside", "the origin lies inside, the centre included",
                       {all_in_reach, {"hit", 0.99}, {"from inside", 0.99}}),
      laid_out<tiny>("tiny", "a tiny radius, seen from a hundred radii or less",
                     {all_in_reach, {"hit", 0.4}, {"miss", 0.1}}),
      laid_out<huge>("huge", "a huge radius: a planet, half the time from just above its ground",
                     {all_in_reach, {"hit", 0.4}, {"miss", 0.02}}),
      laid_out<cancelling>("cancelling", "b² >> 4ac: looking at the surface from just above or below it",
                           {all_in_reach, {"hit", 0.4}, {"from inside", 0.2}}),
      laid_out<interval>("interval", "t_min or t_max at a hit or a few ulps beside it",
                         {all_in_reach, {"hit", 0.4}, {"cut", 0.2}}),
      beyond_the_digits<limb_from_the_horizon>("horizon", horizon_description, {{"hit", 0.3}, {"miss", 0.2}}),
      beyond_the_digits<hard_to_round, maybe_stretch>("hard_to_round", hard::to_round_description,
                                                      {in_reach, {"hit", 0.5}}),
      beyond_the_digits<hard_to_decide, maybe_stretch>(
          "hard_to_decide", "the line touches, or passes by a part that twice the digits hide",
          {in_reach, {"hit", 0.15}, {"miss", 0.3}}),
      placed<near_its_origin>({{"in reach", 0.97}, {"hit", 0.25}, {"miss", 0.4}}),
      transformed<near_its_origin>({all_in_reach, {"hit", 0.3}, {"miss", 0.1}}),
      in_whole_numbers<whole_numbers>(
          "so short that little is rounded: tangents, and chords between whole points of the surface",
          {in_reach, {"hit", 0.66}, {"tangent", 0.24}, {"cut", 0.2}, {"behind", 0.12}, {"from inside", 0.1}}),
      laid_out<exponents>("exponents", "scenes of one size, of any exponent the format has",
                          {{"hit", 0.1}, {"miss", 0.1}}),
      special<Sphere<double>>({{"hit", 0.02}, {"miss", 0.3}}),
      bit_patterns<Sphere<double>>({{"hit", 0.02}, {"miss", 0.5}}),
  };
}

}  // namespace rayproof
