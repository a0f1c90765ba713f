#pragma once
/// \file
/// Rays aimed at triangles: at edges and vertices, from afar, in their planes; slivers and those of no area.

#include "generators/shapes/triangle/scenes.hpp"

namespace rayproof::triangle_family {

[[nodiscard]] inline Scene everyday(Random& random) {
  const Triangle<double> triangle = in_a_room(random);
  return loosened(random, looked_at(random, triangle, in_or_beside(random, triangle)));
}

[[nodiscard]] inline Scene edges(Random& random) {
  const Triangle<double> triangle = whole(random);
  return looked_at_exactly(random, triangle, exactly_on_the_rim(random, triangle));
}

[[nodiscard]] inline Scene near_edges(Random& random) {
  const Triangle<double> triangle = in_a_room(random);
  return looked_at(random, triangle, on_the_rim(random, triangle));
}

/// For the interval: aimed at a point of the triangle.
[[nodiscard]] inline Scene met(Random& random) {
  const bool exactly = random.one_in(3);
  const Triangle<double> triangle = exactly ? whole(random) : in_a_room(random);
  return exactly ? looked_at_exactly(random, triangle, at(triangle, 0.25, random.between(0, 3) / 4.0))
                 : looked_at(random, triangle, inside(random, triangle));
}

[[nodiscard]] inline Scene fans(Random& random) {
  // Vectors of short numbers that are no whole ones: sums and eighths of them are exact.
  const auto short_vector = [&] { return 1 / 64.0 * whole_vector(random, 512); };
  const glm::dvec3 hub = short_vector(), first = hub + short_vector();
  const Triangle<double> triangle{hub, first, hub + short_vector()};
  const glm::dvec3 target = random.one_in(2) ? hub : eighth_between(random, hub, first);
  return looked_at_exactly(random, triangle, target, short_vector());
}

[[nodiscard]] inline Scene slivers(Random& random, Precision precision) {
  Triangle<double> triangle = in_a_room(random);
  const double thinness = std::exp2(random.uniform(-0.75 * draw::digits_of(precision), -3));
  triangle.c = triangle.a + random.uniform(-0.2, 1.2) * (triangle.b - triangle.a) + thinness * triangle.c;
  return looked_at(random, triangle, in_or_beside(random, triangle));
}

[[nodiscard]] inline Scene upright(Random& random) {
  Triangle<double> triangle = whole(random);
  const glm::dvec3 way = triangle.b - triangle.a;
  const int axis = random.between(0, 2);
  triangle.c = triangle.a;  // across the others' way, straight along an axis
  triangle.c[axis] += random.one_in(2) ? 4 : -3;
  if (way[(axis + 1) % 3] == 0 && way[(axis + 2) % 3] == 0) triangle.b[(axis + 1) % 3] += 5;
  const glm::dvec3 on_edge = exactly_on_the_rim(random, triangle);
  return looked_at_exactly(random, triangle,
                           random.one_in(2) ? on_edge : eighth_between(random, on_edge, triangle.c));
}

[[nodiscard]] inline Scene far(Random& random) {
  const Triangle<double> triangle = in_a_room(random, 1);
  const glm::dvec3 target = random.one_in(2) ? on_the_rim(random, triangle) : in_or_beside(random, triangle);
  return looked_at_from_afar(random, triangle, target);
}

[[nodiscard]] inline Scene degenerate(Random& random) {
  const glm::dvec3 a = whole_point(random, 8);
  const glm::dvec3 way = whole_vector(random, 3);
  Triangle<double> triangle{a, a + double{1} * random.between(-2, 2) * way,
                            a + double{1} * random.between(-2, 2) * way};
  if (random.one_in(4)) {  // Rounding lifts the third vertex off the line by an ulp, if at all.
    triangle.a = point_in_a_room(random);
    triangle.b = point_in_a_room(random);
    triangle.c = triangle.a + random.uniform(-1, 2) * (triangle.b - triangle.a);
  }
  return looked_at_exactly(random, triangle, exactly_on_the_rim(random, triangle));
}

[[nodiscard]] inline Scene coplanar(Random& random) {
  const Triangle<double> triangle = whole(random);
  const auto step = [&] { return double{1} * random.between(-2, 2); };
  const double beta = step(), gamma = step();
  const double towards_c = random.one_in(2) ? 1 : 2;
  Scene scene{at(triangle, beta, gamma), at(triangle, step(), towards_c) - triangle.a, triangle};
  if (random.one_in(3)) scene.origin += whole_vector(random, 2);
  return scene;
}

[[nodiscard]] inline Scene near_coplanar(Random& random, Precision precision) {
  const Triangle<double> triangle = in_a_room(random);
  const glm::dvec3 in_plane = inside(random, triangle) - triangle.a;
  const glm::dvec3 any_way = draw::unit_vector(random);
  const glm::dvec3 slope = draw::magnitude<double>(random, -draw::digits_of(precision), -4) * any_way;
  const double length = std::sqrt(dot(in_plane, in_plane)), distance = random.uniform(0, 20);
  return looked_at(triangle, in_or_beside(random, triangle), 1 / length * in_plane + slope, distance, 1);
}

}  // namespace rayproof::triangle_family
