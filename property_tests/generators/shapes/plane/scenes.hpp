#pragma once
/// \file
/// Planes to aim at, in one of their three forms.

#include "generators/aim.hpp"

namespace rayproof::plane_family {

/// A plane as a generator works on it: all point + a·u + b·v.
using Sheet = ParametricPlane;

[[nodiscard]] inline glm::dvec3 at(const Sheet& sheet, double a, double b) {
  return sheet.point + a * sheet.u + b * sheet.v;
}

[[nodiscard]] inline glm::dvec3 normal_of(const Sheet& sheet) { return cross(sheet.u, sheet.v); }

/// The scene with the sheet in one of the three forms.
[[nodiscard]] inline Scene in_some_form(Random& random, const Sheet& sheet, Scene scene) {
  const glm::dvec3 normal = normal_of(sheet);
  const int form = random.between(0, 2);
  if (form == 0) scene.shape = ImplicitPlane{normal, -dot(normal, sheet.point)};
  if (form == 1) scene.shape = PointNormalPlane{sheet.point, normal};
  if (form == 2) scene.shape = sheet;
  return scene;
}

/// A plane in a room; u and v are 1/4 to 4 long and at no small angle.
[[nodiscard]] inline Sheet in_a_room(Random& random) {
  const glm::dvec3 u = draw::unit_vector(random);
  const double slant = random.uniform(-1, 1);
  const glm::dvec3 v = draw::perpendicular(random, u) + slant * u;
  const double length = std::exp2(random.uniform(-2, 2));
  return {point_in_a_room(random), length * u, std::exp2(random.uniform(-2, 2)) * v};
}

/// A plane of whole numbers.
[[nodiscard]] inline Sheet whole(Random& random) {
  for (;;) {
    const Sheet sheet{whole_point(random, 8), whole_vector(random, 3), whole_vector(random, 3)};
    if (normal_of(sheet) != glm::dvec3(0)) return sheet;
  }
}

/// A point of the plane in the room.
[[nodiscard]] inline glm::dvec3 somewhere(Random& random, const Sheet& sheet) {
  const double a = random.uniform(-4, 4);
  return at(sheet, a, random.uniform(-4, 4));
}

/// The same, exact for a plane of whole numbers.
[[nodiscard]] inline glm::dvec3 exactly_somewhere(Random& random, const Sheet& sheet) {
  const double b = random.between(-3, 3);
  return at(sheet, random.between(-3, 3), b);
}

}  // namespace rayproof::plane_family
