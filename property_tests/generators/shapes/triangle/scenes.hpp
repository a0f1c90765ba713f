#pragma once
/// \file
/// Triangles to aim at, and points of theirs.

#include <algorithm>

#include "generators/aim.hpp"

namespace rayproof::triangle_family {

/// a + β(b - a) + γ(c - a).
[[nodiscard]] inline glm::dvec3 at(const Triangle<double>& t, double beta, double gamma) {
  return t.a + beta * (t.b - t.a) + gamma * (t.c - t.a);
}

/// A triangle in a room.
[[nodiscard]] inline Triangle<double> in_a_room(Random& random, double size = 10) {
  const glm::dvec3 a = point_in_a_room(random, size), b = point_in_a_room(random, size);
  return {a, b, point_in_a_room(random, size)};
}

/// A triangle of whole coordinates and an area that is not zero.
[[nodiscard]] inline Triangle<double> whole(Random& random) {
  for (;;) {
    const glm::dvec3 a = whole_point(random, 8), b = whole_point(random, 8), c = whole_point(random, 8);
    if (cross(b - a, c - a) != glm::dvec3(0)) return {a, b, c};
  }
}

/// A point on an edge, at a vertex a third of the time.
[[nodiscard]] inline glm::dvec3 on_the_rim(Random& random, const Triangle<double>& t) {
  const glm::dvec3 corners[] = {t.a, t.b, t.c, t.a};
  const int edge = random.between(0, 2);
  const double way = random.one_in(3) ? 0 : random.uniform(0, 1);
  return corners[edge] + way * (corners[edge + 1] - corners[edge]);
}

/// The same, exact for whole coordinates.
[[nodiscard]] inline glm::dvec3 exactly_on_the_rim(Random& random, const Triangle<double>& t) {
  const glm::dvec3 corners[] = {t.a, t.b, t.c, t.a};
  const int edge = random.between(0, 2);
  return random.one_in(4) ? corners[edge] : eighth_between(random, corners[edge], corners[edge + 1]);
}

/// A point of the triangle's plane, within the triangle about half the time.
[[nodiscard]] inline glm::dvec3 in_or_beside(Random& random, const Triangle<double>& t) {
  const double beta = random.uniform(-0.1, 1.1);
  return at(t, beta, random.uniform(-0.1, 1.1 - std::max(beta, 0.0)));
}

/// A point of the triangle.
[[nodiscard]] inline glm::dvec3 inside(Random& random, const Triangle<double>& t) {
  const double beta = random.unit();
  return at(t, beta, (1 - beta) * random.unit());
}

}  // namespace rayproof::triangle_family
