#pragma once
/// \file
/// Models of faults with planes, triangles and polygons.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ Only faces seen from the front are hit, or only those from the back; front is where the normal points.
/// Of a solid: no ray that starts inside hits.
[[nodiscard]] Answers culls_back(const Case& one, const Answer& exact);
[[nodiscard]] Answers culls_front(const Case& one, const Answer& exact);
[[nodiscard]] Answers misses_from_inside(const Case& one, const Answer& exact);
/// @}

/// A triangle, or a polygon, read as the whole plane it lies in.
[[nodiscard]] std::vector<Case> as_plane(const Case& one);
/// A triangle read as the parallelogram of its sides at a: u + v <= 1 is not tested.
[[nodiscard]] std::vector<Case> as_parallelogram(const Case& one);
/// A triangle without end beyond the edge opposite to a vertex, 0 for a.
template <int vertex>
[[nodiscard]] std::vector<Case> without_edge_opposite(const Case& one) {
  return with_shape<Triangle<double>>(one, [](RayQuestion& /*asked*/, Triangle<double>& triangle) {
    glm::dvec3* const all[] = {&triangle.a, &triangle.b, &triangle.c};
    const glm::dvec3 from = *all[vertex];
    for (const int other : {(vertex + 1) % 3, (vertex + 2) % 3})
      *all[other] = from + 0x1p12 * (*all[other] - from);
    return true;
  });
}

/// @{ Readings of a plane, in any form: the constant of its equation with the other sign; without it; as a
/// distance along the unit normal; only the parallelogram of a parametric plane's u and v.
[[nodiscard]] std::vector<Case> constant_negated(const Case& one);
[[nodiscard]] std::vector<Case> without_constant(const Case& one);
[[nodiscard]] std::vector<Case> constant_as_distance(const Case& one);
[[nodiscard]] std::vector<Case> plane_as_parallelogram(const Case& one);
/// @}
/// The origin's coordinates are added up without the plane's coefficients: t = -(x + y + z + D) / (n·d).
[[nodiscard]] Answers numerator_without_coefficients(const Case& one, const Answer& exact);

/// The sign of one term of λ1 or λ2 is wrong, in the barycentric coordinates of the projection along the
/// normal's largest axis: term 0 or 1 of λ1, 2 or 3 of λ2.
template <int term>
[[nodiscard]] Answers wrong_sign(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
