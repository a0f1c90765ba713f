#pragma once
/// \file
/// The geometry of a stage's items, made by VTK's sources and filters. All coordinates are of the view:
/// its centre is 0, its radius 1.

#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "viz/picture/picture.hpp"
#include "viz/scene/space.hpp"

class vtkActor;
class vtkAlgorithm;
class vtkProperty;
class vtkTransform;

namespace rayproof::viz {

using Geometry = vtkSmartPointer<vtkPolyData>;

/// The sides of a tube, with which those of other round things go: to look at, and while it moves.
inline constexpr int fine_sides = 16, coarse_sides = 6;

/// Tubes around the pieces of a line, and a cone at its end where it has a head.
[[nodiscard]] Geometry line_geometry(const std::vector<SpacePoints>& pieces,
                                     const std::optional<ArrowHead>& head, double radius,
                                     int sides = fine_sides);

/// A point's mark, which faces the eye.
[[nodiscard]] Geometry mark_geometry(MarkShape shape, const glm::dvec3& at, double radius,
                                     const SpaceCamera& camera, int sides = fine_sides);

/// The surface with this outline: a filled polygon (one that crosses itself in strips), a convex solid of its
/// corners and faces, an ellipsoid of a centre and the tips of three conjugate semi-axes.
[[nodiscard]] Geometry polygon_of(const SpacePoints& corners, const std::vector<SpacePoints>& strips = {});
[[nodiscard]] Geometry solid_of(const SpacePoints& corners,
                                const std::vector<std::vector<std::size_t>>& faces);
[[nodiscard]] Geometry ellipsoid_of(const SpacePoints& centre_and_tips, int sides = fine_sides);

/// The line around a polygon, as a tube.
[[nodiscard]] Geometry ring_of(const SpacePoints& corners, double radius, int sides = fine_sides);

/// The line where the surface turns away from the eye, as a tube.
[[nodiscard]] Geometry silhouette_of(const Geometry& surface, const glm::dvec3& eye, double radius,
                                     int sides = fine_sides);

[[nodiscard]] vtkSmartPointer<vtkPoints> points_of(const SpacePoints& points);
/// Each a polyline.
[[nodiscard]] Geometry lines_of(const std::vector<SpacePoints>& lines);
[[nodiscard]] Geometry tubes_of(const Geometry& lines, double radius, int sides);
[[nodiscard]] vtkSmartPointer<vtkActor> actor_of(const Geometry& geometry, const RoleColour& colour);
void set_colour(vtkProperty& property, const RoleColour& colour);
[[nodiscard]] Geometry placed(vtkAlgorithm& source, vtkTransform& transform);

struct Floor {
  vtkSmartPointer<vtkActor> ground;
  vtkSmartPointer<vtkActor> grid;
  std::vector<vtkSmartPointer<vtkActor>> shadows;
};
[[nodiscard]] Floor floor_under(const std::vector<vtkActor*>& actors, const SpaceFloor& place);

}  // namespace rayproof::viz
