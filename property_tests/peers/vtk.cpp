/// \file
/// VTK 9.1: the routines of its cells and boxes (no argument), vtkOBBTree (`tree`) and vtkStaticCellLocator
/// (`locator`) around one cell, vtkBox::IntersectBox (`intersect-box`), and vtkPolygon::PointInPolygon
/// (`point-in-polygon`, apart, since it does not return from all cases). All take the ends of a segment, t
/// running from 0 to 1 (IntersectBox: origin and direction), in double. A cell's tolerance is a length that
/// only says how far outside a hit may be: it is 0, or the least that rounding asks for. Of a ray in a
/// triangle's plane VTK documents that it meets the triangle, so such rays are not asked. Degenerate polygons
/// are excluded by the -1 of PointInPolygon. vtkSphere and vtkCylinder have no routine for rays.
#include <vtkObject.h>
#include <vtkVersion.h>

#include <string_view>

#include "peers/vtk/routines.hpp"

namespace rayproof {
namespace {

peers::Library vtk_library() {
  const std::string release = std::to_string(vtkVersion::GetVTKMajorVersion()) + "." +
                              std::to_string(vtkVersion::GetVTKMinorVersion());
  std::string flags = "-I/usr/include/vtk-" + release;
  for (const char* const part : {"FiltersGeneral", "CommonExecutionModel", "CommonDataModel", "CommonCore"})
    flags += " -lvtk" + std::string(part) + "-" + release;
  return {"VTK", vtkVersion::GetVTKVersion(), peers::built_with(flags),
          "https://gitlab.kitware.com/vtk/vtk/-/issues"};
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  using namespace rayproof::peers::vtk;
  vtkObject::GlobalWarningDisplayOff();
  peers::introduce(count, arguments, vtk_library());
  const std::string_view which = count > 1 ? arguments[1] : "";
  if (which == "tree") return answer_cases(in_tree);
  if (which == "locator") return answer_cases(in_locator);
  if (which == "intersect-box") return answer_cases(intersect_box);
  if (which == "point-in-polygon") return answer_cases(is_in_polygon);
  return answer_cases(takes<PointNormalPlane>(plane), triangle, polygon, box);
}
