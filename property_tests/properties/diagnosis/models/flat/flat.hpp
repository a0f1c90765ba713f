#pragma once
/// \file
/// Models of faults with planes, triangles and polygons.

#include <cmath>
#include <glm/vector_relational.hpp>
#include <optional>
#include <utility>

#include "properties/boundary.hpp"
#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A miss of a ray whose angle with a plane, or a figure in one, is below about `sine`.
[[nodiscard]] Answers misses_grazing(const Case& one, const Answer& exact, double sine);
template <int power>
[[nodiscard]] Answers grazing_missed(const Case& one, const Answer& exact) {
  return misses_grazing(one, exact, std::pow(10.0, power));
}

/// n·d of a plane, or a figure in one: n as it is given, b - a times c - a, or Newell's sum.
[[nodiscard]] std::optional<double> slope_of_surface(const Case& one);

/// A miss where its magnitude is below a limit.
[[nodiscard]] Answers misses_small_slope(const Case& one, const Answer& exact, double least);
template <int power>
[[nodiscard]] Answers small_slope_missed(const Case& one, const Answer& exact) {
  return misses_small_slope(one, exact, std::pow(10.0, power));
}

/// The same where the limit is the machine epsilon of the case's precision.
[[nodiscard]] Answers slope_below_epsilon_missed(const Case& one, const Answer& exact);
/// And where it is that of float, in both precisions.
[[nodiscard]] Answers slope_below_float_epsilon_missed(const Case& one, const Answer& exact);

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
/// A triangle whose edge from a to a vertex, b or c, is taken from the other of the two.
template <int vertex>
[[nodiscard]] std::vector<Case> edge_from_other(const Case& one) {
  return with_shape<Triangle<double>>(one, [](RayQuestion& /*asked*/, Triangle<double>& triangle) {
    const auto& [a, b, c] = triangle;
    if (vertex == 2)
      triangle.c = a + (c - b);
    else
      triangle.b = a + (b - c);
    return true;
  });
}
/// One coordinate of the normal that is a cross product of the shape's vectors has the wrong sign.
[[nodiscard]] Answers by_wrong_normal(const Case& one, int axis);
template <int axis>
[[nodiscard]] Answers wrong_sign_in_normal(const Case& one, const Answer& /*exact*/) {
  return by_wrong_normal(one, axis);
}
/// normal and d of any form of a plane, n·p + d = 0; nothing where the shape is none.
[[nodiscard]] std::optional<std::pair<glm::dvec3, double>> implicit_form(const Case& one);
/// The point that a plane's form has; 0 where it has none.
[[nodiscard]] glm::dvec3 point_of_plane(const Case& one);
/// The origin's coordinates are added up without the plane's coefficients: t = -(x + y + z + D) / (n·d).
[[nodiscard]] Answers numerator_without_coefficients(const Case& one, const Answer& exact);

/// Whether a triangle is hit, and not on an edge.
[[nodiscard]] inline bool is_hit_inside(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  return answer != nullptr && answer->barycentric &&
         glm::all(glm::greaterThan(*answer->barycentric, glm::dvec3(0)));
}

/// Hits on the edge opposite to a vertex, 0 for a, are left out.
template <int vertex>
[[nodiscard]] Answers open_at_edge(const Case& one, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  const bool is_on_edge = answer != nullptr && answer->barycentric && (*answer->barycentric)[vertex] == 0;
  return is_on_edge && is_exact_for_some_method(one) ? Answers{RayAnswer{}} : Answers{};
}
/// The same of rays from behind alone, or from in front alone.
template <int vertex, bool is_from_behind>
[[nodiscard]] Answers open_at_edge_from(const Case& one, const Answer& exact) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  const bool is_there =
      triangle != nullptr && is_behind(*triangle, ray_in_object(*ray_question(one))) == is_from_behind;
  return is_there ? open_at_edge<vertex>(one, exact) : Answers{};
}
/// The part of the triangle's plane in its bounding box.
[[nodiscard]] Answers triangle_bounds(const Case& one, const Answer& exact);
/// A polygon or triangle whose normal is 0 along the axis, or along any where it is -1, is missed: its
/// projection is a line.
[[nodiscard]] Answers upright_is_missed(const Case& one, const Answer& exact, int axis);
/// What lies in a plane along an axis is missed.
[[nodiscard]] Answers flat_bounds_missed(const Case& one, const Answer& exact);
template <int axis>
[[nodiscard]] Answers upright_missed(const Case& one, const Answer& exact) {
  return upright_is_missed(one, exact, axis);
}

/// The answer is wrong, and the polygon's normal is 0 along an axis.
[[nodiscard]] std::optional<bool> wrong_where_upright(const Case& one, const Answer& got,
                                                      const Answer& exact);

/// A polygon is missed where the ray runs along the normal of its first corner.
[[nodiscard]] Answers culls_by_first_corner(const Case& one, const Answer& exact);
/// A ray along the plane is reported as a hit.
[[nodiscard]] std::optional<bool> parallel_is_hit(const Case& one, const Answer& got, const Answer& exact);
/// A figure without area is reported as a hit.
[[nodiscard]] std::optional<bool> no_area_is_hit(const Case& one, const Answer& got, const Answer& exact);
/// Either of the two: what divides by n·d, n of length 0 or not, divides by 0.
[[nodiscard]] std::optional<bool> zero_slope_is_hit(const Case& one, const Answer& got, const Answer& exact);

/// The sign of one term of λ1 or λ2 is wrong, in the barycentric coordinates of the projection along the
/// normal's largest axis: term 0 or 1 of λ1, 2 or 3 of λ2.
template <int term>
[[nodiscard]] Answers wrong_sign(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
