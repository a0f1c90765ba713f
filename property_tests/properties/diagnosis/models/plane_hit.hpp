#pragma once
/// \file
/// Where a line meets the plane of a flat figure, as the models of faults need it: in doubles.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A flat figure's vertices and its Newell normal, in the object's space.
struct FlatFigure {
  std::vector<glm::dvec3> vertices;
  glm::dvec3 normal;
};

/// The normal that the first three vertices give; 0 where they lie on a line.
[[nodiscard]] inline glm::dvec3 normal_of_corner(const std::vector<glm::dvec3>& vertices) {
  return glm::cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
}

/// The triangle or polygon of a case; nothing where it has none, or one without area.
[[nodiscard]] std::optional<FlatFigure> flat_figure(const Case& one);

/// The polygon of a case, be it one without area, with the normal that its first three vertices give.
[[nodiscard]] std::optional<FlatFigure> figure_of_corner(const Case& one);

/// Whether the shape is a plane, or a triangle or polygon with an area.
[[nodiscard]] bool lies_in_a_plane(const Case& one);

/// A point of the figure's plane, projected along the axis where its normal is largest, and the t at which
/// the ray passes it.
struct PlaneHit {
  double t;
  glm::dvec2 point;
  std::vector<glm::dvec2> vertices;
  int axis;  ///< along which it is projected; the two that follow it, cyclically, are x and y here
};

/// A point without the coordinate of that axis.
[[nodiscard]] glm::dvec2 projected(const glm::dvec3& point, int axis);

/// Where the line of the case meets the plane of its figure; nothing where it does not.
[[nodiscard]] std::optional<PlaneHit> plane_hit(const Case& one);
/// The same with the figure given.
[[nodiscard]] std::optional<PlaneHit> plane_hit(const Case& one, const FlatFigure& figure);

/// A figure is projected along one axis always, or where its normal is smallest, or where it is largest with
/// its sign, or along that in which the vertices extend least. Where it is 0 there nothing but a line is
/// seen: what its plane is hit at counts, or is missed.
enum class WrongAxis { x, y, z, smallest, largest_signed, least_extent };
[[nodiscard]] Answers projected_wrongly(const Case& one, WrongAxis wrong, bool is_hit);
template <WrongAxis wrong, bool is_hit>
[[nodiscard]] Answers projected_wrongly(const Case& one, const Answer& /*exact*/) {
  return projected_wrongly(one, wrong, is_hit);
}

/// A triangle whose plane's constant, or n·o, has the wrong sign: t is (n·a + n·o) / (n·d), and what lies
/// there is seen along the normal.
[[nodiscard]] Answers triangle_of_wrong_constant(const Case& one, const Answer& exact);

/// The answer of a ray that hits at t, if it does and t is in its interval.
[[nodiscard]] Answers hit_at(const Case& one, double t, bool is_hit);

}  // namespace rayproof::diagnosis
