#pragma once
/// \file
/// What the geometry of lines, marks and surfaces is made with.

#include <vtkPoints.h>

#include "viz/vtk/space/geometry.hpp"

class vtkAlgorithm;
class vtkTransform;

namespace rayproof::viz {

[[nodiscard]] vtkSmartPointer<vtkPoints> points_of(const SpacePoints& points);
/// Each a polyline.
[[nodiscard]] Geometry lines_of(const std::vector<SpacePoints>& lines);
/// Tubes around all lines of the geometry.
[[nodiscard]] Geometry tubes_of(const Geometry& lines, double radius, int sides);
/// What the source makes, under the transform.
[[nodiscard]] Geometry placed(vtkAlgorithm& source, vtkTransform& transform);

}  // namespace rayproof::viz
