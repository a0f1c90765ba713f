#pragma once
/// \file
/// Spheres through a whole point, on rays whose t there is known to a bit, and moved by next to nothing:
/// along the surface, where the square of the step counts, or anyhow. Every number that has too many digits
/// is the difference of the centre's coordinate and the origin's.

#include "generators/lattice.hpp"
#include "generators/shapes/sphere/whole.hpp"

namespace rayproof::sphere_family {

/// The sphere of radius |point| on the ray through its point `point` at t, t in steps of 2^-bits.
[[nodiscard]] inline Scene moved_by_nothing(Random& random, Precision precision, const glm::dvec3& point,
                                            const glm::dvec3& direction, const lattice::Whole& t, int bits) {
  const int digits = draw::digits_of(precision);
  const bool along_the_surface = random.one_in(2);
  const glm::dvec3 any = whole_vector(random, 4);
  const int bits_of_step =
      static_cast<int>(random.uniform(along_the_surface ? 0.7 : 1.4, along_the_surface ? 1.3 : 1.9) * digits);
  const glm::dvec3 step = std::exp2(-bits_of_step) * (along_the_surface ? cross(point, any) : any);
  Scene scene{{}, direction, Ball{{}, std::sqrt(dot(point, point))}};
  for (int i = 0; i < 3; ++i) {
    const lattice::Whole way =
        t * lattice::Whole(static_cast<int>(direction[i])) - lattice::whole(point[i], bits);
    const auto [high, low] = lattice::difference(precision, way + lattice::whole(step[i], bits), bits);
    std::get<Ball>(scene.shape).center[i] = high;
    scene.origin[i] = low;
  }
  return scene;
}

[[nodiscard]] inline glm::dvec3 some_whole_point(Random& random) {
  static constexpr std::array points{glm::dvec3(1, 2, 2), glm::dvec3(0, 3, 4), glm::dvec3(2, 3, 6),
                                     glm::dvec3(1, 4, 8), glm::dvec3(4, 4, 7), glm::dvec3(2, 6, 9)};
  return rearranged(random, points.at(static_cast<std::size_t>(random.between(0, points.size() - 1))));
}

/// t beside the middle of two numbers, or beside the end of the interval.
[[nodiscard]] inline Scene hard_to_round(Random& random, Precision precision) {
  const glm::dvec3 point = some_whole_point(random);
  glm::dvec3 direction(0);
  while (dot(direction, point) == 0) direction = whole_vector(random, 3);
  const int digits = draw::digits_of(precision), bits = 3 * digits, e = random.between(0, 4);
  const bool ends_there = random.one_in(3);
  const lattice::Whole half = lattice::some_whole(random, digits), M = 2 * half + (ends_there ? 0 : 1);
  Scene scene = moved_by_nothing(random, precision, point, direction, M << (bits - digits + e), bits);
  scene.aimed_at = lattice::number(M, digits - e);
  if (ends_there) (random.one_in(2) ? scene.t_min : scene.t_max) = scene.aimed_at;
  return scene;
}

/// The ray passes (0, 0, 0), near which the sphere's limb is, from so far away that all digits cancel.
[[nodiscard]] inline Scene limb_from_the_horizon(Random& random, Precision precision) {
  const glm::dvec3 direction = toward_the_horizon(random),
                   any = draw::perpendicular(random, normalize(direction));
  const double radius = random.uniform(0.5, 2),
               beside =
                   draw::magnitude<double>(random, random.one_in(2) ? -5 : -draw::digits_of(precision), -1);
  return {horizon(random, precision, direction), direction, Ball{radius * (1 + beside) * any, radius}};
}

/// The ray touches, or misses it by next to nothing.
[[nodiscard]] inline Scene hard_to_decide(Random& random, Precision precision) {
  const glm::dvec3 point = some_whole_point(random), direction = cross(point, whole_vector(random, 3));
  const glm::dvec3 along = direction == glm::dvec3(0) ? across(random, point) : direction;
  const int bits = 3 * draw::digits_of(precision);
  const lattice::Whole t = lattice::some_whole(random, 10) << (bits - 9);
  return moved_by_nothing(random, precision, point, along, t, bits);
}

}  // namespace rayproof::sphere_family
