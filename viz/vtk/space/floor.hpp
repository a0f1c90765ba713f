#pragma once
/// \file
/// A floor below a scene, with a grid and shadows, so that heights and depths can be read.

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <vector>

namespace rayproof::viz {

struct Floor {
  vtkSmartPointer<vtkActor> ground;
  vtkSmartPointer<vtkActor> grid;
  std::vector<vtkSmartPointer<vtkActor>> shadows;
};

/// Below the lowest of the actors near the view, level to `up`, an axis of the world. The view's centre and
/// radius are those of the world: the grid's lines stand at round coordinates of it. Light falls straight
/// down.
[[nodiscard]] Floor floor_under(const std::vector<vtkActor*>& actors, const glm::dvec3& up,
                                const glm::dvec3& centre, double radius);

/// How far apart the grid's lines are in the world: 1, 2 or 5 times a power of ten.
[[nodiscard]] double grid_step(double radius);

}  // namespace rayproof::viz
