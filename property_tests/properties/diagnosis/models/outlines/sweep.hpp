#pragma once
/// \file
/// The ray from a point whose crossings with a polygon's sides are counted, and what a subject says then.

#include "properties/diagnosis/models/models.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {

/// Where a subject's ray from the point goes that crosses the sides: along x, or against it; of a figure that
/// is projected along y, x and z may stand for x and y in either order; along y, or against it.
enum class Sweep { along, against, along_in_order, against_in_order, upward, downward };

/// The point and the outline turned so that the sweep goes along x.
[[nodiscard]] PlaneHit swept(Sweep sweep, PlaneHit hit);

/// The same mirrored: a vertex on the point's level that counted as below it counts as above.
[[nodiscard]] PlaneHit upside_down(PlaneHit seen);

/// What a subject answers that takes the point for inside, or for outside.
[[nodiscard]] Answers place_at(const Case& one, const PlaneHit& seen, bool is_inside);

}  // namespace rayproof::diagnosis
