#pragma once
/// \file
/// Readings of a parallelepiped that are not what is given.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A parallelepiped without end along an edge: in doubles, since a corner so far away is rounded.
template <int edge>
[[nodiscard]] std::vector<Case> endless_parallelepiped(const Case& one) {
  Case in_doubles = one;
  in_doubles.precision = Precision::float64;
  return with_shape<Parallelepiped<double>>(in_doubles, [](RayQuestion& /*asked*/, auto& solid) {
    const glm::dvec3 along = 0x1p20 * solid.edges[edge];
    solid.corner -= along;
    solid.edges[edge] = 2.0 * along;
    return true;
  });
}
/// Along that edge a ray has no end, so that hits at infinity may be added, or none.
void add_endless_along(const Case& one, int edge, Answers& answers);
/// What a subject answers that does not look at the faces at the ends of an edge.
template <int edge>
[[nodiscard]] Answers without_faces_of_edge(const Case& one, const Answer& exact) {
  Answers answers = read_as<endless_parallelepiped<edge>>(one, exact);
  if (!answers.empty()) add_endless_along(one, edge, answers);
  return answers;
}
/// The same beyond the corner alone: the edge is taken for an endless half line.
template <int edge>
[[nodiscard]] std::vector<Case> half_endless_parallelepiped(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    solid.edges[edge] *= 0x1p30;
    return true;
  });
}
/// One edge is taken twice, or half, as long. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers edge_of_other_length(const Case& one, const Answer& exact);
/// An edge with another one added to it: the diagonal of their face is taken for the edge.
template <int edge, int other>
[[nodiscard]] std::vector<Case> diagonal_for_edge(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    solid.edges[edge] += solid.edges[other];
    return true;
  });
}

/// @{ Readings of a parallelepiped: the box with two of its opposite corners; its bounding box; with each
/// edge as long as its square; its edges taken for orthogonal, so that projections on them are coordinates;
/// its corner taken for the centre; its edges for the vertices next to the corner; the matrix of its edges
/// transposed; the box from the corner with the lengths of the edges along x, y and z.
[[nodiscard]] std::vector<Case> parallelepiped_as_box(const Case& one);
[[nodiscard]] std::vector<Case> parallelepiped_as_bounds(const Case& one);
[[nodiscard]] std::vector<Case> edges_times_length(const Case& one);
[[nodiscard]] std::vector<Case> edges_as_orthogonal(const Case& one);
[[nodiscard]] std::vector<Case> corner_as_centre(const Case& one);
[[nodiscard]] std::vector<Case> edges_as_vertices(const Case& one);
[[nodiscard]] std::vector<Case> edges_transposed(const Case& one);
[[nodiscard]] std::vector<Case> edges_along_axes(const Case& one);
/// @}

/// What has a volume below 10^power is missed.
[[nodiscard]] Answers small_volume_missed(const Case& one, const Answer& exact, double least);
template <int power>
[[nodiscard]] Answers small_volume_missed(const Case& one, const Answer& exact) {
  return small_volume_missed(one, exact, std::pow(10.0, power));
}

/// The same of a volume below 10^power of the product of the edges' lengths.
[[nodiscard]] Answers flat_solid_missed(const Case& one, const Answer& exact, double share);
template <int power>
[[nodiscard]] Answers flat_solid_missed(const Case& one, const Answer& exact) {
  return flat_solid_missed(one, exact, std::pow(10.0, power));
}

/// What passes by the upright box between the corner and the opposite one is missed: the other corners may
/// lie outside of it.
[[nodiscard]] Answers missed_beside_two_corners(const Case& one, const Answer& exact);

/// What is missed by an elimination that exchanges no rows: a parallelepiped, or a triangle, where the first
/// edge has x = 0, or the next pivot is 0.
[[nodiscard]] Answers zero_pivot_missed(const Case& one, const Answer& exact);

/// A parallelepiped whose edges are left-handed, their determinant negative, is missed.
[[nodiscard]] Answers left_handed_missed(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
