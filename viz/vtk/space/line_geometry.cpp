#include <vtkAppendPolyData.h>
#include <vtkConeSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "viz/vtk/space/geometry_parts.hpp"

namespace rayproof::viz {
namespace {

/// With its z axis turned into the direction.
vtkSmartPointer<vtkTransform> turned(const glm::dvec3& at, const glm::dvec3& z, double size) {
  const glm::dvec3 aside = std::abs(z.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(aside, z));
  const glm::dvec3 y = glm::cross(z, x);
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i) {
    matrix->SetElement(i, 0, size * x[i]);
    matrix->SetElement(i, 1, size * y[i]);
    matrix->SetElement(i, 2, size * z[i]);
    matrix->SetElement(i, 3, at[i]);
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  return transform;
}

/// The pieces of a line in its pattern; lengths in units of its radius.
std::vector<SpacePoints> pieces_of(const SpacePoints& line, double radius, Pattern pattern) {
  if (pattern == Pattern::solid) return {line};
  const double dash = (pattern == Pattern::dashed ? 8 : 2) * radius;
  const double pause = 5 * radius;
  std::vector<SpacePoints> pieces;
  double walked = 0;  // since the last dash began
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = glm::length(line[i + 1] - line[i]);
    for (double at = 0; at < length;) {
      const bool is_dash = walked < dash;
      const double step = std::min((is_dash ? dash : dash + pause) - walked, length - at);
      if (is_dash) {
        const auto point = [&](double s) { return line[i] + s / length * (line[i + 1] - line[i]); };
        pieces.push_back({point(at), point(at + step)});
      }
      at += step;
      walked += step;
      if (walked >= dash + pause - 1e-12) walked = 0;
    }
  }
  return pieces;
}

}  // namespace

Geometry tube_of(const SpacePoints& line, double radius, Pattern pattern) {
  return tubes_of(lines_of(pieces_of(line, radius, pattern)), radius);
}

Geometry arrow_of(const glm::dvec3& from, const glm::dvec3& to, double radius) {
  const double length = glm::length(to - from);
  if (length == 0) return vtkSmartPointer<vtkPolyData>::New();
  const glm::dvec3 along = (to - from) / length;
  const double head = std::min(9 * radius, 0.5 * length);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(24);
  cone->SetHeight(head);
  cone->SetRadius(0.36 * head);
  const glm::dvec3 middle = to - 0.5 * head * along;
  cone->SetCenter(middle.x, middle.y, middle.z);
  cone->SetDirection(along.x, along.y, along.z);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(tube_of({from, to - 0.9 * head * along}, radius, Pattern::solid));
  both->AddInputConnection(cone->GetOutputPort());
  both->Update();
  return both->GetOutput();
}

Geometry mark_geometry(MarkShape shape, const glm::dvec3& at, double radius, const glm::dvec3& toward) {
  const auto transform = turned(at, toward, radius);
  switch (shape) {
    case MarkShape::ring: {
      vtkNew<vtkParametricTorus> torus;
      torus->SetRingRadius(1.15);
      torus->SetCrossSectionRadius(0.3);
      vtkNew<vtkParametricFunctionSource> source;
      source->SetParametricFunction(torus);
      return placed(*source, *transform);
    }
    case MarkShape::diamond: {
      vtkNew<vtkPlatonicSolidSource> source;
      source->SetSolidTypeToOctahedron();
      transform->Scale(1.7, 1.7, 1.7);
      return placed(*source, *transform);
    }
    case MarkShape::cross: {
      vtkNew<vtkAppendPolyData> both;
      both->AddInputData(tube_of({{-1.1, -1.1, 0}, {1.1, 1.1, 0}}, 0.3, Pattern::solid));
      both->AddInputData(tube_of({{-1.1, 1.1, 0}, {1.1, -1.1, 0}}, 0.3, Pattern::solid));
      return placed(*both, *transform);
    }
    case MarkShape::dot: {
      vtkNew<vtkSphereSource> source;
      source->SetRadius(1);
      source->SetThetaResolution(24);
      source->SetPhiResolution(24);
      return placed(*source, *transform);
    }
  }
  return vtkSmartPointer<vtkPolyData>::New();
}

}  // namespace rayproof::viz
