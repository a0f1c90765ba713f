#pragma once
/// \file
/// The floor below a scene, as actors of VTK.

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "viz/scene/space.hpp"

namespace rayproof::viz {

struct Floor {
  vtkSmartPointer<vtkActor> ground;
  vtkSmartPointer<vtkActor> grid;
  std::vector<vtkSmartPointer<vtkActor>> shadows;
};

/// The floor with the shadows of the actors.
[[nodiscard]] Floor floor_under(const std::vector<vtkActor*>& actors, const SpaceFloor& place);

}  // namespace rayproof::viz
