#pragma once
/// \file
/// What the plain arithmetic of a guest may lose beyond the units of the contracts, which are measured by
/// what our own methods take care of: factors on the promised bounds, 1 for most cases.

#include "case/case.hpp"

namespace rayproof {

/// Of verdict and residual. A polygon's normal from differences to its first vertex loses digits where that
/// vertex lies far from the others; the contracts' unit knows the distances from (0, 0, 0) alone.
[[nodiscard]] double allowed_of_hits(const Case& one);

/// Of the normal: the same, and under a map as much again as its condition. An inverse, or cofactors, by
/// plain products are off by that. Of a sphere or a cylinder, as many radii away as it is: the textbook's (p
/// - c) / r of a rounded p turns, and is no longer of length 1, as p(t) is `far` radii away, and as much more
/// as t's own residual, in units, puts p off the surface.
[[nodiscard]] double allowed_of_normal(const Case& one, double far = 1, double residual = 0);

/// Of the point of a hit at t. The unit knows p(t) alone; who goes from a vertex along the edges by u and v,
/// from the centre along the normal, or back from an object's space, rounds as much as the shape is large, as
/// u and v are ill conditioned, and as the map is.
[[nodiscard]] double allowed_of_point(const Case& one, double t, double condition_of_coordinates);

}  // namespace rayproof
