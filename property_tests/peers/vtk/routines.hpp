#pragma once
/// \file
/// VTK's routines as functions of a ray, or a point, and a shape. Each throws Unsupported where VTK's
/// documentation excludes the case.

#include <vtkMath.h>

#include "peers/reproduction.hpp"

namespace rayproof::peers::vtk {

using Hit = std::optional<double>;

/// @{ The routines of its planes and cells.
Hit plane(const Ray<double>& ray, const PointNormalPlane& shape);
Hit triangle(const Ray<double>& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);
Hit polygon(const Ray<double>& ray, const std::vector<glm::dvec3>& vertices);
/// @}

/// @{ vtkBox::IntersectWithLine and vtkBox::IntersectBox.
std::vector<double> box(const Ray<double>& ray, glm::dvec3 low, glm::dvec3 high);
Hit intersect_box(const Ray<double>& ray, glm::dvec3 low, glm::dvec3 high);
/// @}

/// vtkPolygon::PointInPolygon.
bool is_in_polygon(const PointAndPolygon<double>& asked);

/// @{ A triangle met through a locator around it.
Hit in_tree(const Ray<double>& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);
Hit in_locator(const Ray<double>& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);
/// @}

/// vtkPolygon fires random rays within the polygon's plane: the same for each case, so that an answer does
/// not depend on those before. A new program has this very seed.
inline void repeat_random_numbers() { vtkMath::RandomSeed(1177); }

/// Rays in the plane of the triangle, or so near to it that rounding decides, mean another thing to VTK.
inline void refuse_coplanar(const Ray<double>& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 normal = cross(b - a, c - a);
  const double steepness = std::abs(dot(normal, ray.direction));
  if (steepness <= 1e-14 * glm::length(normal) * glm::length(ray.direction)) throw Unsupported();
}

}  // namespace rayproof::peers::vtk
