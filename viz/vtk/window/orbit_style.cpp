#include "viz/vtk/window/orbit_style.hpp"

#include <vtkObjectFactory.h>

namespace rayproof::viz {

vtkStandardNewMacro(OrbitStyle);

}  // namespace rayproof::viz
