#pragma once
/// \file
/// The places where a case can lie on a boundary of what is a hit.

#include <bitset>
#include <cstddef>

namespace rayproof {

/// What decides a case that lies exactly on a boundary. Code has a comparison for each of these, so that one
/// may be open and the others closed.
enum class BoundaryPlace {
  tangent,  ///< a double root; a solid touched at one t
  /// The same by a ray along an axis: who makes its direction a unit vector rounds nothing there, either.
  tangent_along_axis,
  at_origin,  ///< a hit exactly at the ray's origin, where t_min is 0, that is neither of the next two
  entering,   ///< the same of a ray that enters there, and has a second hit
  leaving,    ///< the same of a ray that leaves a solid there
  t_min,      ///< a hit exactly at a t_min that is not 0
  t_max,      ///< a hit exactly at t_max
  edge_a,     ///< the triangle's edge opposite to a, without its ends
  edge_b,
  edge_c,
  vertex,     ///< a vertex of a triangle, or of a polygon in the plane
  low_face,   ///< a line in a face of a box at its min, or of a parallelepiped at its corner
  high_face,  ///< the same of the opposite faces
  low_rim,    ///< an open cylinder's rim at z = 0, crossed by the ray
  high_rim,   ///< an open cylinder's rim at z = height
  edge,       ///< any other edge, or the boundary of a polygon
  // Of shapes without faces; a place is one of its shape.
  in_surface = low_face,      ///< a line that runs inside a plane, a figure's plane or an open side: a miss
  level_side = low_face,      ///< a level side of a polygon in the plane
  upright_side = high_face,   ///< an upright one
  level_rim = high_face,      ///< an open cylinder's rim, in whose plane the ray runs
  along_side = edge_a,        ///< a line in the side of a capped cylinder, which meets both its rims
  no_radius = low_face,       ///< a sphere that is a point
  edge_a_behind = high_face,  ///< the triangle's edges, met from behind
  edge_b_behind = low_rim,
  edge_c_behind = high_rim,
  closing_side = leaving,  ///< the side from the last vertex to the first
  greatest = at_origin,    ///< of a polygon in the plane beside another place: at its greatest x or y
  least = entering         ///< the same at its least
};
inline constexpr std::size_t boundary_place_count = 16;

/// Some of these places.
using BoundaryPlaces = std::bitset<boundary_place_count>;

}  // namespace rayproof
