#pragma once
/// \file
/// Polygons in space: an outline of the plane put into a plane of space, with a ray through the point.

#include "generators/hard_to_round.hpp"
#include "generators/layout.hpp"
#include "generators/outline_layouts.hpp"
#include "generators/whole.hpp"

namespace rayproof::polygon_family {

using outline_layout::PolygonCase;

[[nodiscard]] inline Polygon<double> lifted(const Sheet& sheet, const Outline& vertices) {
  Polygon<double> polygon;
  for (const Vec2<double>& vertex : vertices) polygon.vertices.push_back(at(sheet, vertex));
  return polygon;
}

/// A sheet of whole numbers, along the axes half the time: what is exact in the plane is exact in space.
[[nodiscard]] inline Sheet whole_sheet(Random& random) {
  const int x = random.between(0, 2), y = (x + random.between(1, 2)) % 3, z = 3 - x - y;
  Sheet sheet{whole_point(random, 8), glm::dvec3(0), glm::dvec3(0)};
  sheet.u[x] = 1;
  sheet.v[y] = 1;
  if (random.one_in(2)) {
    sheet.u[z] = random.between(-3, 3);
    sheet.v[z] = random.between(-3, 3);
  }
  return sheet;
}

/// A whole vector that does not run along the sheet.
[[nodiscard]] inline glm::dvec3 across(Random& random, const Sheet& sheet) {
  for (;;) {
    const glm::dvec3 sight = whole_vector(random, 4);
    if (dot(sight, cross(sheet.u, sheet.v)) != 0) return sight;
  }
}

/// A sheet turned anyhow: rounding lifts the vertices off it.
[[nodiscard]] inline Sheet any_sheet(Random& random) {
  const glm::dmat3 turn = rotation(random);
  return {point_in_a_room(random), turn[0], turn[1]};
}

/// A layout of the plane in space, the ray aimed at its point.
template <const outline_layout::Layout& layout>
[[nodiscard]] Scene in_space(Random& random) {
  const PolygonCase plan = layout.plan(random);
  if constexpr (layout.is_exact) {
    const Sheet sheet = whole_sheet(random);
    return looked_at_exactly(random, lifted(sheet, plan.vertices), at(sheet, plan.point),
                             across(random, sheet));
  }
  const Sheet sheet = any_sheet(random);
  return looked_at(random, lifted(sheet, plan.vertices), at(sheet, plan.point));
}

/// A short outline in a plane of short numbers, seen along a short vector.
[[nodiscard]] inline Scene whole_numbers(Random& random) {
  const PolygonCase plan = outline_layout::whole.plan(random);
  const Sheet sheet = whole_sheet(random);
  glm::dvec3 sight = short_vector(random);
  while (dot(sight, cross(sheet.u, sheet.v)) == 0) sight = short_vector(random);
  if (random.one_in(8)) sight = 1.0 * random.between(-2, 2) * sheet.u + sheet.v;
  return looked_at_exactly(random, lifted(sheet, plan.vertices), at(sheet, plan.point), sight);
}

/// Stars in space, looked at from all sides: some rays start behind the polygon.
[[nodiscard]] inline Scene everyday(Random& random) {
  return loosened(random, in_space<outline_layout::everyday>(random));
}

[[nodiscard]] inline Scene far(Random& random) {
  const PolygonCase plan = outline_layout::either_plan(random);
  const Sheet sheet = any_sheet(random);
  return looked_at_from_afar(random, lifted(sheet, plan.vertices), at(sheet, plan.point));
}

[[nodiscard]] inline Scene coplanar(Random& random) {
  const PolygonCase plan = outline_layout::level.plan(random);
  const Sheet sheet = whole_sheet(random);
  const double along_v = random.between(1, 3), along_u = random.between(-3, 3);
  Scene scene{at(sheet, plan.point), along_u * sheet.u + along_v * sheet.v, lifted(sheet, plan.vertices)};
  if (random.one_in(3)) scene.origin += whole_vector(random, 2);
  return scene;
}

/// The ray comes in almost along the plane.
[[nodiscard]] inline Scene near_coplanar(Random& random, Precision precision) {
  const PolygonCase plan = outline_layout::either_plan(random);
  const Sheet sheet = any_sheet(random);
  const double slope = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  const glm::dvec3 normal = cross(sheet.u, sheet.v), along = draw::perpendicular(random, normal);
  return looked_along(random, lifted(sheet, plan.vertices), at(sheet, plan.point), along + slope * normal);
}

/// For the interval: a point inside, exact a third of the time.
[[nodiscard]] inline Scene met(Random& random) {
  return random.one_in(3) ? in_space<outline_layout::boundary>(random)
                          : in_space<outline_layout::everyday>(random);
}

/// An everyday outline whose vertices are exactly in a plane, on a grid, under a map now and then; and what
/// the map makes of it.
struct PolygonOnGrid {
  hard::ShortMap map;
  Sheet sheet;  ///< in the world
  PolygonCase plan;
  Polygon<double> own, in_world;

  PolygonOnGrid(Random& random, const hard::Grid& grid)
      : map(hard::ShortMap::some(random)), plan(outline_layout::everyday.plan(random)) {
    const Sheet drawn = lattice::on_grid(any_sheet(random), hard::before_the_map(grid) - 3);
    plan.vertices = lattice::on_grid(plan.vertices, 3);
    own = lifted(drawn, plan.vertices);
    sheet = {map.point(drawn.point), map.vector(drawn.u), map.vector(drawn.v)};
    in_world = lifted(sheet, plan.vertices);
  }
  [[nodiscard]] hard::WholePlane plane(const hard::Grid& grid) const {
    return hard::plane_along(grid, sheet.point, sheet.u, sheet.v);
  }
};

[[nodiscard]] inline Scene hard_to_round(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& grid) {
    const PolygonOnGrid drawn(random, grid);
    return drawn.map.put(
        hard::to_round(random, grid, drawn.own, drawn.plane(grid), at(drawn.sheet, drawn.plan.point)));
  });
}

[[nodiscard]] inline Scene hard_to_decide(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& grid) {
    const PolygonOnGrid drawn(random, grid);
    const auto& vertices = drawn.in_world.vertices;
    const auto i = static_cast<std::size_t>(random.between(0, static_cast<int>(vertices.size()) - 1));
    const glm::dvec3 corner = vertices[i], side = vertices[(i + 1) % vertices.size()] - corner;
    return drawn.map.put(
        hard::to_decide(random, grid, drawn.own, corner, side, corner + random.unit() * side));
  });
}

/// Begins at a vertex now and then.
[[nodiscard]] inline Scene hard_to_meet(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& grid) {
    const PolygonOnGrid drawn(random, grid);
    const glm::dvec3 target =
        random.one_in(4) ? drawn.in_world.vertices.front() : at(drawn.sheet, drawn.plan.point);
    return drawn.map.put(hard::to_meet(random, grid, drawn.own, drawn.plane(grid), target));
  });
}

/// A polygon of a few units 1e2 to 1e4 from the origin of coordinates, and a ray beside its boundary.
[[nodiscard]] inline Scene off_origin(Random& random) {
  return displaced(random, loosened(random, in_space<outline_layout::near_boundary>(random)));
}

/// Whole vertices anywhere in space: in no plane, so that it counts how the format flattens them.
[[nodiscard]] inline Scene not_flat(Random& random) {
  Polygon<double> polygon;
  const int size = random.between(2, 6);
  for (int k = random.between(4, 7); k > 0; --k) polygon.vertices.push_back(whole_point(random, size));
  const glm::dvec3 target = eighth_between(random, polygon.vertices[0], polygon.vertices[2]);
  return loosened(random, looked_at_exactly(random, polygon, target));
}

}  // namespace rayproof::polygon_family
