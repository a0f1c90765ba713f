#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {
namespace {

void enclose(Hull& hull, const Parallelepiped<double>& solid) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    auto p = Point::from(solid.corner);
    for (unsigned edge = 0; edge < 3; ++edge)
      if ((corner >> edge & 1U) != 0) p = p + Point::from(solid.edges[edge]);
    hull.add(p);
  }
}

}  // namespace

FigureKind parallelepiped_figures() {
  return figure_kind<parallelepiped::Topic, Parallelepiped<double>, enclose>();
}

}  // namespace rayproof::render
