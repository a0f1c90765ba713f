#pragma once
/// \file
/// Models of faults in the six faces of a parallelepiped, or of a box, each a point and two edges, and in the
/// frame of its edges.

#include <algorithm>

#include "properties/diagnosis/models/hits/factor.hpp"
#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A point of a face's plane by its two edges e and f: its coordinates u, v, and what they are made of.
struct FacePoint {
  double u, v;           ///< in edges
  double along, across;  ///< (p - corner)·e, (p - corner)·f
  double e, f;           ///< the edges' lengths
  double determinant;    ///< e²f² - (e·f)²
};

/// The first two hits, or the first and the last, of a subject that takes a face's point for inside by that
/// rule.
[[nodiscard]] Answers hits_of_faces(const Case& one, bool (*is_inside)(const FacePoint& point));
template <bool (*is_inside)(const FacePoint& point)>
[[nodiscard]] Answers by_faces(const Case& one, const Answer& /*exact*/) {
  return hits_of_faces(one, is_inside);
}

[[nodiscard]] constexpr bool are_in_square(double u, double v) {
  return 0 <= u && u <= 1 && 0 <= v && v <= 1;
}
/// @{ u and v, or one of them, are not divided; are lengths; are projections; their sum is at most 1.
[[nodiscard]] inline bool undivided_face(const FacePoint& p) {
  return are_in_square(p.u * p.determinant, p.v * p.determinant);
}
[[nodiscard]] inline bool undivided_u(const FacePoint& p) { return are_in_square(p.u * p.determinant, p.v); }
[[nodiscard]] inline bool unit_face(const FacePoint& p) { return are_in_square(p.u * p.e, p.v * p.f); }
[[nodiscard]] inline bool unit_projections(const FacePoint& p) { return are_in_square(p.along, p.across); }
[[nodiscard]] inline bool triangular_face(const FacePoint& p) {
  return are_in_square(p.u, p.v) && p.u + p.v <= 1;
}
/// One of the two is not looked at; both are, and what lies on an edge is left out.
[[nodiscard]] inline bool endless_along_e(const FacePoint& p) { return 0 <= p.v && p.v <= 1; }
[[nodiscard]] inline bool endless_along_f(const FacePoint& p) { return 0 <= p.u && p.u <= 1; }
[[nodiscard]] inline bool open_face(const FacePoint& p) {
  constexpr double rounded = 0x1p-40;
  return are_in_square(p.u, p.v) && std::min(p.u, p.v) > rounded && std::max(p.u, p.v) < 1 - rounded;
}
[[nodiscard]] inline bool rectangular_face(const FacePoint& p) {
  return are_in_square(p.along / (p.e * p.e), p.across / (p.f * p.f));
}
/// @}

/// The edges' triple product.
[[nodiscard]] std::optional<double> volume(const Case& one);
/// The length of the ray's direction in the edges' frame.
[[nodiscard]] std::optional<double> length_in_edges(const Case& one);
/// @{ Readings of a parallelepiped: edges divided by their triple product; doubled; halved; from -1 to 1; one
/// edge turned round; the corner's opposite.
[[nodiscard]] std::vector<Case> edges_over_volume(const Case& one);
[[nodiscard]] std::vector<Case> edges_doubled(const Case& one);
[[nodiscard]] std::vector<Case> edges_halved(const Case& one);
[[nodiscard]] std::vector<Case> edges_both_ways(const Case& one);
[[nodiscard]] std::vector<Case> corner_negated(const Case& one);
[[nodiscard]] std::vector<Case> edge_negated(const Case& one, std::size_t edge);
template <std::size_t edge>
[[nodiscard]] std::vector<Case> edge_negated(const Case& one) {
  return edge_negated(one, edge);
}
/// @}

}  // namespace rayproof::diagnosis
