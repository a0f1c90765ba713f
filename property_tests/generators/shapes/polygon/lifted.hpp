#pragma once
/// \file
/// Polygons in space: an outline of the plane put into a plane of space, with a ray through the point.

#include "generators/affine.hpp"
#include "generators/aim.hpp"
#include "generators/outline_layouts.hpp"

namespace rayproof::polygon_family {

using outline_layout::Plan;

/// Where the outline's plane lies in space: (x, y) is at origin + x·u + y·v.
struct Sheet {
  glm::dvec3 origin, u, v;

  [[nodiscard]] glm::dvec3 at(const Vec2<double>& place) const { return origin + place.x * u + place.y * v; }
};

[[nodiscard]] inline Polygon<double> lifted(const Sheet& sheet, const Outline& vertices) {
  Polygon<double> polygon;
  for (const Vec2<double>& vertex : vertices) polygon.vertices.push_back(sheet.at(vertex));
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
template <class Layout>
struct Lifted : Layout {
  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Plan plan = Layout::plan(random);
    const Sheet sheet = Layout::exact ? whole_sheet(random) : any_sheet(random);
    Scene scene;
    if (Layout::exact)
      look_exactly(random, scene, sheet.at(plan.point), across(random, sheet));
    else
      look_at(random, scene, sheet.at(plan.point));
    scene.shape = lifted(sheet, plan.vertices);
    return scene;
  }
};

/// Stars in space, looked at from all sides: some rays start behind the polygon.
struct Everyday : outline_layout::Everyday {
  [[nodiscard]] static Scene scene(Random& random, int digits) {
    Scene scene = Lifted<outline_layout::Everyday>::scene(random, digits);
    loosen(random, scene);
    return scene;
  }
};

struct FarOff {
  static constexpr const char* name = "far";
  static constexpr const char* description =
      "the ray comes from 1e2 to 1e6 away, half the time near the boundary";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Plan plan = random.one_in(2) ? outline_layout::Everyday::plan(random)
                                       : outline_layout::NearBoundary::plan(random);
    const Sheet sheet = any_sheet(random);
    Scene scene;
    look_from_afar(random, scene, sheet.at(plan.point), 1);
    scene.shape = lifted(sheet, plan.vertices);
    return scene;
  }
};

struct Coplanar {
  static constexpr const char* name = "coplanar";
  static constexpr const char* description =
      "in whole numbers: the ray runs in the polygon's plane, or parallel to it";

  [[nodiscard]] static Scene scene(Random& random, int /*digits*/) {
    const Plan plan = outline_layout::Level::plan(random);
    const Sheet sheet = whole_sheet(random);
    Scene scene;
    scene.origin = sheet.at(plan.point);
    const double along_v = random.between(1, 3), along_u = random.between(-3, 3);
    scene.direction = along_u * sheet.u + along_v * sheet.v;
    if (random.one_in(3)) scene.origin += whole_vector(random, 2);
    scene.shape = lifted(sheet, plan.vertices);
    return scene;
  }
};

/// For the interval: a point inside, exact a third of the time.
struct Cut {
  [[nodiscard]] static Scene scene(Random& random, int digits) {
    return random.one_in(3) ? Lifted<outline_layout::Boundary>::scene(random, digits)
                            : Lifted<outline_layout::Everyday>::scene(random, digits);
  }
};

}  // namespace rayproof::polygon_family
