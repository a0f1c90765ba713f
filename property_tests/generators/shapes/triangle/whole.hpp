#pragma once
/// \file
/// Triangles and rays of numbers so short that nothing made of them is rounded.

#include "generators/shapes/triangle/layouts.hpp"
#include "generators/whole.hpp"

namespace rayproof::triangle_family {

/// A triangle of small whole coordinates; seldom one without area.
[[nodiscard]] inline Triangle<double> short_triangle(Random& random) {
  const glm::dvec3 a = whole_point(random, 4), b = whole_point(random, 4);
  return {a, b, whole_point(random, 4)};
}

/// Aimed at an edge, a vertex, the line through an edge but beside it, or anywhere in the plane; or running
/// in the plane. A quarter of the triangles are upright.
[[nodiscard]] inline Scene whole_numbers(Random& random) {
  if (random.one_in(4)) return upright(random);
  const Triangle<double> t = short_triangle(random);
  const int kind = random.between(0, 7);
  if (kind == 0) {
    const glm::dvec3 along = on_an_edge(random, t, [&] { return quarters(random, -1, 2); }) - t.a;
    const double beta = quarters(random, -1, 1);
    const glm::dvec3 origin = at(t, beta, quarters(random, -1, 1));
    return {origin, along == glm::dvec3(0) ? short_vector(random) : along, t, 1};
  }
  const bool at_a_vertex = kind == 1, anywhere = kind == 2;
  const bool beside = kind == 3;
  const auto share = [&] {
    return at_a_vertex ? 0 : beside ? quarters(random, -1, 2) : quarters(random, 0, 1);
  };
  const double beta = quarters(random, -1, 1);
  const glm::dvec3 target = anywhere ? at(t, beta, quarters(random, -1, 1)) : on_an_edge(random, t, share);
  return looked_at_exactly(random, t, target, short_vector(random));
}

}  // namespace rayproof::triangle_family
