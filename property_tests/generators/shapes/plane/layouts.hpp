#pragma once
/// \file
/// Rays aimed at planes: from near and far, almost along them, exactly in them.

#include "generators/shapes/plane/scenes.hpp"

namespace rayproof::plane_family {

[[nodiscard]] inline Scene everyday(Random& random) {
  const Sheet sheet = in_a_room(random);
  Scene scene = looked_at(random, sheet, somewhere(random, sheet));
  if (random.one_in(2)) scene = loosened(random, scene);
  if (random.one_in(4)) scene.direction = -scene.direction;
  return in_some_form(random, sheet, scene);
}

[[nodiscard]] inline Scene near_parallel(Random& random, Precision precision) {
  const Sheet sheet = in_a_room(random);
  const double angle = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  const glm::dvec3 any_way = draw::unit_vector(random);
  const glm::dvec3 off = random.uniform(-1, 1) * any_way;
  const glm::dvec3 origin = somewhere(random, sheet) + off;
  const glm::dvec3 slope = angle * draw::unit_vector(random);
  return in_some_form(random, sheet, {origin, random.uniform(-2, 2) * sheet.u + sheet.v + slope});
}

[[nodiscard]] inline Scene in_plane(Random& random) {
  const Sheet sheet = whole(random);
  const auto step = [&] { return double{1} * random.between(-3, 3); };
  const double a = step(), b = step();
  const double along_v = random.between(1, 3);
  Scene scene{at(sheet, a, b), step() * sheet.u + along_v * sheet.v};
  if (random.one_in(3)) scene.origin += whole_vector(random, 2);
  return in_some_form(random, sheet, scene);
}

[[nodiscard]] inline Scene surface(Random& random) {
  const bool exactly = random.one_in(3);
  const Sheet sheet = exactly ? whole(random) : in_a_room(random);
  const glm::dvec3 origin = exactly ? exactly_somewhere(random, sheet) : somewhere(random, sheet);
  return in_some_form(random, sheet, {origin, any_direction(random)});
}

[[nodiscard]] inline Scene far(Random& random) {
  Sheet sheet = in_a_room(random);
  const double distance = std::pow(10, random.uniform(2, 6));
  const glm::dvec3 target = somewhere(random, sheet);
  if (random.one_in(2)) return in_some_form(random, sheet, looked_at_from_afar(random, sheet, target));
  const Scene scene = looked_at(random, sheet, target);
  const double b = distance * random.uniform(-1, 1);
  sheet.point = at(sheet, distance * random.uniform(-1, 1), b);
  return in_some_form(random, sheet, scene);
}

[[nodiscard]] inline Scene tiny_normal(Random& random, Precision precision) {
  Sheet sheet = in_a_room(random);
  const Scene scene = looked_at(random, sheet, somewhere(random, sheet));
  const double size = std::exp2(random.uniform(-draw::digits_of(precision) / 4.0, -2));
  sheet.u *= size;
  sheet.v *= size;
  return in_some_form(random, sheet, scene);
}

/// For the interval: half the time in whole numbers, so that the hit is exactly where the ray was aimed.
[[nodiscard]] inline Scene met(Random& random) {
  const bool exactly = random.one_in(2);
  const Sheet sheet = exactly ? whole(random) : in_a_room(random);
  return in_some_form(random, sheet,
                      exactly ? looked_at_exactly(random, sheet, exactly_somewhere(random, sheet))
                              : looked_at(random, sheet, somewhere(random, sheet)));
}

}  // namespace rayproof::plane_family
