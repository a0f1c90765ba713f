#pragma once
/// \file
/// Models of faults in how a subject finds whether a flat figure's point is inside: in a triangle's weights,
/// or in the point itself.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// What Möller and Trumbore's formula finds: the weights of b and c, and t. `size` is what it divides by,
/// -n·d.
struct TriangleHit {
  double beta = 0, gamma = 0, t = 0, size = 0, area_squared = 0;
};

/// The weights and t of the case; nothing where it has no triangle, or the ray runs along it.
[[nodiscard]] std::optional<TriangleHit> triangle_hit(const Case& one);
/// What a subject answers whose weights and t these are, and who compares them rightly, or otherwise.
[[nodiscard]] Answers by_weights(const Case& one, const TriangleHit& hit);
[[nodiscard]] Answers given_weights(const Case& one, const TriangleHit& hit, bool is_hit);

/// What a subject answers that finds `change(hit)`.
template <void (*change)(TriangleHit&)>
[[nodiscard]] Answers with_weights(const Case& one, const Answer& /*exact*/) {
  auto hit = triangle_hit(one);
  if (!hit) return {};
  change(*hit);
  return by_weights(one, *hit);
}

/// @{ Not divided: by the determinant, both weights; by the square of the normal.
inline void undivided_weights(TriangleHit& hit) {
  hit.beta *= hit.size;
  hit.gamma *= hit.size;
}
inline void undivided_by_area(TriangleHit& hit) {
  hit.beta *= hit.area_squared;
  hit.gamma *= hit.area_squared;
}
/// @}
/// The hit is right, and of the weights that are given that of b, of c, both, or all three are not divided by
/// the determinant, or its magnitude. An answer for each.
[[nodiscard]] Answers given_undivided(const Case& one, const Answer& exact);
/// The determinant is taken without its sign, of either order of its factors.
[[nodiscard]] Answers determinant_without_sign(const Case& one, const Answer& exact);
/// Of one edge the point's way is taken from the vertex opposite to it. An answer for each edge.
[[nodiscard]] Answers edge_by_opposite_vertex(const Case& one, const Answer& exact);

/// One weight is not divided by the determinant, at all or before it is compared with 0 and 1 itself.
[[nodiscard]] Answers undivided(const Case& one, double TriangleHit::*weight);
template <double TriangleHit::*weight>
[[nodiscard]] Answers undivided(const Case& one, const Answer& /*exact*/) {
  return undivided(one, weight);
}
/// Both weights are compared without their signs.
[[nodiscard]] Answers weights_without_signs(const Case& one, const Answer& exact);
/// The factors of one of the cross products are exchanged.
inline void exchanged_factors(TriangleHit& hit) {
  hit.gamma = -hit.gamma;
  hit.t = -hit.t;
}

/// One of u, v and t is what another one is, or 0: another product of vectors stands in its place. An answer
/// for each such mistake, always in the same order.
[[nodiscard]] Answers another_product(const Case& one, const Answer& exact);

/// A polygon is cut into the fan of triangles from its first vertex, each in its own plane: the first of them
/// that is hit counts, or the nearest.
[[nodiscard]] Answers fan_of_triangles(const Case& one, const Answer& exact);

/// The ray's way to the triangle is taken from b, or from c, where a belongs.
[[nodiscard]] Answers way_from_other_vertex(const Case& one, const Answer& exact);

/// A triangle that is hit where the weight of one vertex is negative and the others are not: one of its edges
/// is looked at from the wrong side.
[[nodiscard]] Answers beyond_edge(const Case& one, int vertex);
template <int vertex>
[[nodiscard]] Answers edge_turned(const Case& one, const Answer& /*exact*/) {
  return beyond_edge(one, vertex);
}

/// The point that is compared with a figure's sides.
using TestedPoint = glm::dvec3 (*)(const Ray<double>& ray, double t, const glm::dvec3& normal);
/// What a subject answers that finds the right t, and looks whether another point is inside.
[[nodiscard]] Answers where_inside(const Case& one, TestedPoint point);
template <TestedPoint point>
[[nodiscard]] Answers tested_at(const Case& one, const Answer& /*exact*/) {
  return where_inside(one, point);
}

/// @{ o + t·n; o - t·d; t·d; o + t·d/|d|.
[[nodiscard]] inline glm::dvec3 along_normal(const Ray<double>& ray, double t, const glm::dvec3& normal) {
  return ray.origin + t * normal;
}
[[nodiscard]] inline glm::dvec3 against_direction(const Ray<double>& ray, double t,
                                                  const glm::dvec3& /*normal*/) {
  return ray.origin - t * ray.direction;
}
[[nodiscard]] inline glm::dvec3 without_start(const Ray<double>& ray, double t,
                                              const glm::dvec3& /*normal*/) {
  return t * ray.direction;
}
[[nodiscard]] inline glm::dvec3 by_unit_direction(const Ray<double>& ray, double t,
                                                  const glm::dvec3& /*normal*/) {
  return ray.origin + t * glm::normalize(ray.direction);
}
/// @}

}  // namespace rayproof::diagnosis
