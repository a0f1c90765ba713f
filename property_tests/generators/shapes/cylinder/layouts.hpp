#pragma once
/// \file
/// Rays aimed at cylinders: at tangents, rims and caps, from afar, from inside and from the surface.

#include "generators/shapes/cylinder/scenes.hpp"

namespace rayproof::cylinder_family {

[[nodiscard]] inline Scene everyday(Random& random) {
  const Tube tube = in_a_room(random);
  const double share = random.uniform(0, 1.8);
  const double z = tube.height * random.uniform(-0.5, 1.5);
  return loosened(random, looked_at(random, tube, at(tube, any_turn(random), share, z)));
}

[[nodiscard]] inline Scene far(Random& random) {
  const Tube tube = in_a_room(random);
  const double z = tube.height * random.unit(), share = random.uniform(0, 1.1);
  Scene scene = looked_at_from_afar(random, tube, at(tube, any_turn(random), share, z));
  if (!random.one_in(2)) return scene;
  // Turned so that it touches the side where it was aimed at.
  const Turn turn = any_turn(random);
  const glm::dvec3 sight = 0.5 * tangent(tube, turn) + glm::dvec3(0, 0, random.uniform(-0.1, 0.1));
  const double height = tube.height * random.unit();
  return looked_at(tube, at(tube, turn, random.uniform(0.99, 1.01), height), sight, scene.aimed_at, 1);
}

[[nodiscard]] inline Scene grazing(Random& random, Precision precision) {
  if (random.one_in(4)) {
    const Tube tube = whole(random);
    const Turn turn = whole_turn(random);
    const double z = double{1} * random.between(0, static_cast<int>(tube.height));
    const glm::dvec3 slope(0, 0, random.between(-2, 2));
    return looked_at_exactly(random, tube, exactly_at(tube, turn, z),
                             glm::round(tangent(tube, turn)) + slope);
  }
  const Tube tube = in_a_room(random);
  const Turn turn = any_turn(random);
  const double beside = 1 + draw::magnitude<double>(random, 2 - draw::digits_of(precision), -10);
  const glm::dvec3 sight = 0.5 * tangent(tube, turn) + glm::dvec3(0, 0, random.uniform(-1, 1));
  const double length = direction_length(random), distance = random.uniform(0, 10);
  return looked_at(tube, at(tube, turn, beside, tube.height * random.unit()), sight, distance, length);
}

/// At the side, in whole numbers or in rounded ones; `z_of(tube, exactly)` is where.
[[nodiscard]] Scene at_the_side(Random& random, auto&& z_of) {
  const bool exactly = random.one_in(2);
  const Tube tube = exactly ? whole(random) : in_a_room(random);
  const double z = z_of(tube, exactly);
  return exactly ? looked_at_exactly(random, tube, exactly_at(tube, whole_turn(random), z))
                 : looked_at(random, tube, at(tube, any_turn(random), 1, z));
}

[[nodiscard]] inline Scene rims(Random& random, Precision precision) {
  return at_the_side(random, [&](const Tube& tube, bool exactly) {
    const double end = some_end(random, tube);
    if (exactly || random.one_in(2)) return end;
    const double step = draw::small_step(random, precision);
    return random.one_in(2) ? end + step : end - step;
  });
}

/// For the interval: aimed at the side.
[[nodiscard]] inline Scene side(Random& random) {
  return at_the_side(random, [&](const Tube& tube, bool exactly) {
    return tube.height * (exactly ? random.between(0, 4) / 4.0 : random.unit());
  });
}

[[nodiscard]] inline Scene caps(Random& random) {
  const Tube tube = in_a_room(random);
  const double share =
      random.one_in(2) ? random.uniform(0, 1.2) : 1 + draw::magnitude<double>(random, -20, -6);
  const double z = some_end(random, tube);
  return looked_at(random, tube, at(tube, any_turn(random), share, z));
}

[[nodiscard]] inline Scene axis_parallel(Random& random, Precision precision) {
  const bool in_side = random.one_in(2);
  const Tube tube = in_side ? whole(random) : in_a_room(random);
  const double share = random.uniform(0, 1.3);
  glm::dvec3 origin =
      in_side ? exactly_at(tube, whole_turn(random), 0) : at(tube, any_turn(random), share, 0);
  origin.z = double{1} * random.between(-4, 12);
  const double sign = random.one_in(2) ? 1 : -1;
  glm::dvec3 direction{0, 0, sign * direction_length(random)};
  if (random.one_in(4)) direction.x = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  return {origin, direction, tube};
}

/// Aimed at the side, from without or within; most are tall, so that the ray gets through.
[[nodiscard]] inline Scene near_parallel(Random& random, Precision precision) {
  Tube tube = in_a_room(random);
  tube.height *= std::exp2(random.uniform(0, 4));
  const Turn turn = any_turn(random), way = any_turn(random);
  const double slope = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  const glm::dvec3 sight{slope * way.cosine, slope * way.sine, random.one_in(2) ? 1 : -1};
  return looked_along(random, tube, at(tube, turn, 1, tube.height * random.unit()), sight);
}

[[nodiscard]] inline Scene cap_planes(Random& random) {
  const bool exactly = random.one_in(2);
  const Tube tube = exactly ? whole(random) : in_a_room(random);
  const double z = some_end(random, tube);
  if (exactly) {
    const glm::dvec3 sight{random.between(1, 4), random.between(-4, 4), 0};
    return looked_at_exactly(random, tube, exactly_at(tube, whole_turn(random), z), sight);
  }
  const Turn sight = any_turn(random);
  const double length = direction_length(random), distance = random.uniform(0, 20);
  const double share = random.uniform(0, 1.3);
  return looked_at(tube, at(tube, any_turn(random), share, z), {sight.cosine, sight.sine, 0}, distance,
                   length);
}

[[nodiscard]] inline Scene flat_ellipses(Random& random) {
  Tube tube = in_a_room(random);
  (random.one_in(2) ? tube.rx : tube.ry) *= std::pow(10, random.uniform(-4, 4));
  const double share = random.one_in(2) ? random.uniform(0, 1.5) : random.uniform(0.999, 1.001);
  const double z = tube.height * random.uniform(-0.2, 1.2);
  return looked_at(random, tube, at(tube, any_turn(random), share, z));
}

[[nodiscard]] inline Scene inside(Random& random) {
  const Tube tube = in_a_room(random);
  const double share = random.one_in(8) ? 0 : random.uniform(0, 0.999);
  const double z = tube.height * random.uniform(0.001, 0.999);
  return {at(tube, any_turn(random), share, z), any_direction(random), tube};
}

[[nodiscard]] inline glm::dvec3 on_the_surface(Random& random, const Tube& tube) {
  const bool on_the_side = random.one_in(2);
  const double z = on_the_side ? tube.height * random.unit() : some_end(random, tube);
  const double share = on_the_side ? 1 : random.unit();
  return at(tube, any_turn(random), share, z);
}

[[nodiscard]] inline Scene surface(Random& random) {
  if (!random.one_in(3)) {
    const Tube tube = in_a_room(random);
    return {on_the_surface(random, tube), any_direction(random), tube};
  }
  const Tube tube = whole(random);
  const double z = random.between(0, static_cast<int>(tube.height));
  return {exactly_at(tube, whole_turn(random), z), any_direction(random), tube};
}

[[nodiscard]] inline Scene no_height(Random& random) {
  const bool exactly = random.one_in(2);
  Tube tube = exactly ? whole(random) : in_a_room(random);
  tube.height = random.one_in(2) ? 0 : std::exp2(random.uniform(-20, -4));
  if (exactly) return looked_at_exactly(random, tube, exactly_at(tube, whole_turn(random), 0));
  const double share = random.uniform(0, 1.2);
  return looked_at(random, tube, at(tube, any_turn(random), share, 0));
}

}  // namespace rayproof::cylinder_family
