#pragma once
/// \file
/// What of a case can be taken hold of in its picture, and the case that comes of moving it.

#include <vector>

#include "viz/flat/projection.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

enum class Grip {
  origin,  ///< of the ray; its direction stays
  tip,     ///< of the ray's arrow; its origin stays
  point    ///< of a question about a point and a polygon
};

/// A point to take hold of.
struct Handle {
  Grip grip = Grip::origin;
  glm::dvec3 at{};
  double t = 1;  ///< of a tip: it is the point origin + t·direction
};

/// The handles that are to be seen in the projection's frame: of a ray's stage its origin and the last point
/// of its arrow inside the frame, of a point in a polygon the point. None where the scene shows something
/// else than the case.
[[nodiscard]] std::vector<Handle> handles_of(const Stage& stage, const ScreenProjection& projection);

/// Where a handle of one case is in another: after it was moved, say.
[[nodiscard]] glm::dvec3 place_of(const Handle& handle, const Case& one);

/// The case with the handle moved to `to`. Coordinates that the move changes become the shortest decimals
/// that distinguish points at a distance of `resolution`, then numbers of the case's precision; the others
/// keep their bits. Throws a Refusal where the format refuses the case: a zero direction, say.
[[nodiscard]] Case moved(const Case& one, const Handle& handle, const glm::dvec3& to, double resolution);

}  // namespace rayproof::viz
