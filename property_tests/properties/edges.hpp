#pragma once
/// \file
/// Whether a ray passes an edge of a solid, as far as rounding can say.

#include <optional>

#include "case/case.hpp"

namespace rayproof {

/// A box, or a parallelepiped as the unit cube of its own coordinates, with the ray in the same space.
struct Cube {
  Ray<double> ray;
  glm::dvec3 low, high;
};

/// Those of the case; nothing where its shape is another.
[[nodiscard]] std::optional<Cube> cube_in(const Case& one);

/// A box as the parallelepiped that it is.
[[nodiscard]] inline Parallelepiped<double> as_parallelepiped(const Box<double>& box) {
  const glm::dvec3 size = box.max - box.min;
  return {box.min, {{{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}}}};
}

/// What rounding may make of a place, as a share of the lengths that it is made of.
[[nodiscard]] constexpr double share_of_rounding(Precision precision) {
  return precision == Precision::float32 ? 0x1p-18 : 0x1p-40;
}

/// Whether the ray at t is at the rim of a capped cylinder, to a share of the lengths there: a plain method
/// asks once for the side and once for the cap, and may miss the solid's hit between them. Never of another
/// shape.
[[nodiscard]] bool is_at_rim(const Case& one, double t, double share);

/// Whether it is at a rim, or where two faces of a box or parallelepiped meet.
[[nodiscard]] bool is_at_edge(const Case& one, double t, double share);

}  // namespace rayproof
