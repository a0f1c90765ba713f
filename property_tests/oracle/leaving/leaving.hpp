#pragma once
/// \file
/// Does a ray that leaves a surface meet it again? Exact, and independent of every strategy that places the
/// origin: from the shape, the rounded ray and the piece of surface that is left, and from nothing else.
///
/// A *piece* is what one equation f = 0 describes: the plane of a flat shape, a sphere, a face of a solid, a
/// cylinder's side or cap; f grows outward, or along the normal of a flat shape. A direction *leaves the
/// piece* at a point for the front where f does not fall along it there, and for the back where f does not
/// grow: in a plane that is the sign of normal·direction, and on a curved surface the same at the foot of the
/// point, since f's gradient is the normal of the surface of f that goes through the point. A ray that leaves
/// from the surface itself never meets a convex shape again, so that whatever is met is a fault of the
/// origin.

#include <glm/vec3.hpp>
#include <rayproof/spawn/side.hpp>

#include "case/case.hpp"

namespace rayproof::oracle {

/// One piece of a shape's surface. A flat shape and a sphere have one; a box and a parallelepiped six, face
/// `upper` of pair `index`; a cylinder its side (index 0) and two caps (index 1).
struct SurfacePiece {
  int index = 0;
  bool is_upper = false;
};

/// The piece with this normal, in the shape's own space: of any length, and rounded.
[[nodiscard]] SurfacePiece piece_of(const Shape& shape, const glm::dvec3& normal);

/// Whether a shape has an inside, to which rays are refracted: a sphere, a box, a parallelepiped, a cylinder
/// (an open one, too: the inside of the tube).
[[nodiscard]] bool has_inside(const Shape& shape);

/// The sign of the derivative of the piece's f along the ray at its origin.
[[nodiscard]] int climb(const RayQuestion& ray, const SurfacePiece& piece);

/// What becomes of a ray that leaves a piece.
enum class Departure {
  clear,      ///< meets nothing that it should not
  false_hit,  ///< meets the shape it has left, at t >= 0
  skipped,    ///< was to start inside a solid, and starts beyond it: its far side is missed
  no_origin   ///< starts nowhere: a coordinate of the origin is NaN or infinite
};

/// Judges the ray, whose direction leaves the piece for `side` at the foot of the hit, by its rounded origin.
/// To the front of a solid, and to either side of a flat shape, no hit is true. To the back of a solid the
/// origin must be strictly inside: then the one hit is the true far side.
[[nodiscard]] Departure depart(const RayQuestion& ray, const SurfacePiece& piece, spawn::Side side);

/// How the scene of a hit is measured, in double: how large it is, and how thin its solid.
struct SceneExtent {
  double size;  ///< the largest coordinate of the point and of the shape in the world, about
  double
      width;  ///< the least distance of two parallel planes with the solid between them, about; or infinite
};
[[nodiscard]] SceneExtent extent_of(const RayQuestion& question, const glm::dvec3& point);

}  // namespace rayproof::oracle
