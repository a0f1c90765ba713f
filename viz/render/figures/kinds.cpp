/// \file
/// The registration of the scenes' layer: what each shape brings to a scene.

#include "viz/render/figures.hpp"

namespace rayproof::render {

// Each in figures/NAME.cpp.
FigureKind plane_figures();
FigureKind triangle_figures();
FigureKind polygon_figures();
FigureKind sphere_figures();
FigureKind box_figures();
FigureKind parallelepiped_figures();
FigureKind cylinder_figures();

const std::vector<FigureKind>& figure_kinds() {
  static const std::vector<FigureKind> kinds{
      plane_figures(),           //
      triangle_figures(),        //
      polygon_figures(),         //
      sphere_figures(),          //
      box_figures(),             //
      parallelepiped_figures(),  //
      cylinder_figures(),        //
  };
  return kinds;
}

}  // namespace rayproof::render
