#pragma once
/// \file
/// Triangles and points of theirs, and rays aimed at them: at edges and vertices, from afar, in their planes;
/// slivers and those of no area.

#include <algorithm>

#include "generators/hard_to_round.hpp"

namespace rayproof::triangle_family {

/// a + β(b - a) + γ(c - a).
[[nodiscard]] inline glm::dvec3 at(const Triangle<double>& t, double beta, double gamma) {
  return t.a + beta * (t.b - t.a) + gamma * (t.c - t.a);
}

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

/// A point on an edge, at `share()` of its length.
[[nodiscard]] inline glm::dvec3 on_an_edge(Random& random, const Triangle<double>& t, auto&& share) {
  const glm::dvec3 corners[] = {t.a, t.b, t.c, t.a};
  const int edge = random.between(0, 2);
  return corners[edge] + share() * (corners[edge + 1] - corners[edge]);
}

/// A point on an edge, at a vertex a third of the time.
[[nodiscard]] inline glm::dvec3 on_the_rim(Random& random, const Triangle<double>& t) {
  return on_an_edge(random, t, [&] { return random.one_in(3) ? 0 : random.unit(); });
}

/// The same, exact for whole coordinates.
[[nodiscard]] inline glm::dvec3 exactly_on_the_rim(Random& random, const Triangle<double>& t) {
  return on_an_edge(random, t, [&] { return random.one_in(4) ? 0 : random.between(0, 8) / 8.0; });
}

/// A point of the triangle's plane, within the triangle about half the time.
[[nodiscard]] inline glm::dvec3 in_or_beside(Random& random, const Triangle<double>& t) {
  const double beta = random.uniform(-0.1, 1.1);
  return at(t, beta, random.uniform(-0.1, 1.1 - std::max(beta, 0.0)));
}

[[nodiscard]] inline glm::dvec3 inside(Random& random, const Triangle<double>& t) {
  const double beta = random.unit();
  return at(t, beta, (1 - beta) * random.unit());
}

[[nodiscard]] inline Scene everyday(Random& random) {
  const Triangle<double> triangle = in_a_room(random);
  return loosened(random, looked_at(random, triangle, in_or_beside(random, triangle)));
}

[[nodiscard]] inline Scene edges(Random& random) {
  const Triangle<double> triangle = whole(random);
  return looked_at_exactly(random, triangle, exactly_on_the_rim(random, triangle));
}

[[nodiscard]] inline Scene near_edges(Random& random, Precision precision) {
  const Triangle<double> triangle = in_a_room(random);
  return maybe_aside(random, precision, looked_at(random, triangle, on_the_rim(random, triangle)));
}

/// Aimed at a point within the triangle, nearer to one vertex than to the others.
[[nodiscard]] inline Scene corners(Random& random) {
  const Triangle<double> triangle = in_a_room(random);
  const double beta = std::exp2(-random.uniform(2, 8));
  return looked_at(random, triangle, at(triangle, beta, std::exp2(-random.uniform(2, 8))));
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

/// One edge is down to 2^-12 times as long as another.
[[nodiscard]] inline Scene slender(Random& random, Precision precision) {
  Triangle<double> t = in_a_room(random);
  t.b = t.a + std::exp2(-random.uniform(2, 12)) * (t.b - t.a);
  if (random.one_in(2)) t = {t.b, t.c, t.a};
  if (random.one_in(2)) t = {t.a, t.c, t.b};
  const double share = random.unit();
  const glm::dvec3 target =
      random.one_in(2) ? on_the_rim(random, t) : at(t, share, (1 - share) * random.unit());
  return maybe_aside(random, precision, looked_at(random, t, target));
}

[[nodiscard]] inline Scene upright(Random& random) {
  Triangle<double> triangle = whole(random);
  const glm::dvec3 edge = triangle.b - triangle.a;
  const int axis = random.between(0, 2);
  triangle.c = triangle.a;  // across the other edge, straight along an axis
  triangle.c[axis] += random.one_in(2) ? 4 : -3;
  if (edge[(axis + 1) % 3] == 0 && edge[(axis + 2) % 3] == 0) triangle.b[(axis + 1) % 3] += 5;
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
  const glm::dvec3 direction = whole_vector(random, 3);
  Triangle<double> triangle{a, a + double{1} * random.between(-2, 2) * direction,
                            a + double{1} * random.between(-2, 2) * direction};
  if (random.one_in(4)) {  // Rounding lifts the third vertex off the line by an ulp, if at all.
    triangle.a = point_in_a_room(random);
    triangle.b = point_in_a_room(random);
    triangle.c = triangle.a + random.uniform(-1, 2) * (triangle.b - triangle.a);
  }
  Scene scene = looked_at_exactly(random, triangle, exactly_on_the_rim(random, triangle));
  if (random.one_in(3)) scene.origin += whole_vector(random, 2);  // past it
  return scene;
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

/// In tenths, as people write scenes: what lies in one plane there is rounded off it.
[[nodiscard]] inline Scene decimals(Random& random) {
  const auto tenths = [&](int most) { return random.between(-most, most) / 10.0; };
  const int last = random.between(0, 2);
  const double slope_x = tenths(20), slope_y = tenths(20);
  const auto in_plane = [&](double height, int most) {
    const double x = tenths(most), y = tenths(most);
    const glm::dvec3 v(slope_x * x + slope_y * y + height, x, y);
    return glm::dvec3(v[last], v[(last + 1) % 3], v[(last + 2) % 3]);
  };
  const double height = tenths(9);
  const Triangle<double> triangle{in_plane(height, 90), in_plane(height, 90), in_plane(height, 90)};
  glm::dvec3 direction = in_plane(0, 9);
  while (direction == glm::dvec3(0)) direction = in_plane(0, 9);
  return {in_plane(height, 90), direction, triangle};
}

[[nodiscard]] inline Scene near_coplanar(Random& random, Precision precision) {
  const Triangle<double> triangle = in_a_room(random);
  const glm::dvec3 in_plane = inside(random, triangle) - triangle.a;
  const glm::dvec3 any_direction = draw::unit_vector(random);
  const glm::dvec3 slope = draw::magnitude<double>(random, -draw::digits_of(precision), -4) * any_direction;
  const double length = std::sqrt(dot(in_plane, in_plane)), distance = random.uniform(0, 20);
  return looked_at(triangle, in_or_beside(random, triangle), 1 / length * in_plane + slope, distance, 1);
}

/// A triangle on a grid, under a map now and then, and what the map makes of it.
struct TriangleOnGrid {
  hard::ShortMap map;
  Triangle<double> own, in_world;

  TriangleOnGrid(Random& random, const hard::Grid& grid)
      : map(hard::ShortMap::some(random)),
        own(lattice::on_grid(in_a_room(random), hard::before_the_map(grid))),
        in_world{map.point(own.a), map.point(own.b), map.point(own.c)} {}
  [[nodiscard]] hard::WholePlane plane(const hard::Grid& grid) const {
    return hard::plane_along(grid, in_world.a, in_world.b - in_world.a, in_world.c - in_world.a);
  }
};

/// β or γ is beside the middle of two numbers.
[[nodiscard]] inline Scene hard_coordinates(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& /*grid*/) {
    hard::ShortMap map = hard::ShortMap::uneven(random);
    Triangle<double> t = whole(random);
    if (random.one_in(2)) {
      t = {glm::dvec3(0), t.b - t.a, t.c - t.a};
      map.by = glm::dvec3(0);
    }
    const glm::dvec3 a = map.point(t.a), ab = map.point(t.b) - a, ac = map.point(t.c) - a;
    const bool is_beta = random.one_in(2);
    return map.put(
        hard::to_round_a_coordinate(random, precision, t, a, is_beta ? ac : ab, is_beta ? ab : ac));
  });
}

[[nodiscard]] inline Scene hard_to_round(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& grid) {
    const TriangleOnGrid t(random, grid);
    return t.map.put(hard::to_round(random, grid, t.own, t.plane(grid), inside(random, t.in_world)));
  });
}

[[nodiscard]] inline Scene hard_to_decide(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& grid) {
    const TriangleOnGrid t(random, grid);
    const auto& [a, b, c] = t.own;
    const Triangle<double> turned[] = {t.own, {b, c, a}, {c, a, b}};  // any edge is the first of one
    const glm::dvec3 edge = t.in_world.b - t.in_world.a, target = t.in_world.a + random.unit() * edge;
    return t.map.put(hard::to_decide(random, grid, turned[random.between(0, 2)], t.in_world.a, edge, target));
  });
}

/// Along an axis past the vertex (0, 0, 0) by next to nothing, half the time on the line of an edge.
[[nodiscard]] inline Scene beside_a_vertex(Random& random, Precision precision) {
  const Triangle<double> t = whole(random);
  const glm::dvec3 b = t.b - t.a, c = t.c - t.a;
  const int axis = random.between(0, 2);
  glm::dvec3 direction(0), off = random.one_in(2) ? whole_vector(random, 4) : random.one_in(2) ? b : c;
  direction[axis] = random.one_in(2) ? 1 : -1;
  off *= std::exp2(std::floor(-random.uniform(0.5, 2.5) * draw::digits_of(precision)));
  off[axis] = 0;
  const Triangle<double> turned[] = {{{}, b, c}, {b, c, {}}, {c, {}, b}};
  return {(random.one_in(2) ? off : -off) - double{1} * random.between(0, 3) * direction, direction,
          turned[random.between(0, 2)]};
}

/// Begins at a vertex now and then.
[[nodiscard]] inline Scene hard_to_meet(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& grid) {
    const TriangleOnGrid t(random, grid);
    const glm::dvec3 target = random.one_in(4) ? t.in_world.a : inside(random, t.in_world);
    return t.map.put(hard::to_meet(random, grid, t.own, t.plane(grid), target));
  });
}

/// A triangle of a few units 1e2 to 1e4 from the origin of coordinates, and a ray beside its edge.
[[nodiscard]] inline Scene off_origin(Random& random, Precision precision) {
  Scene scene = near_edges(random, precision);
  return displaced(random, scene);
}

}  // namespace rayproof::triangle_family
