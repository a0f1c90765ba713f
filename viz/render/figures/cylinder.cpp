#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {
namespace {

void enclose(Hull& hull, const Cylinder<double>& cylinder) {
  hull.add_box({-cylinder.rx, -cylinder.ry, 0.0}, {cylinder.rx, cylinder.ry, cylinder.height});
}

}  // namespace

FigureKind cylinder_figures() { return figure_kind<cylinder::Topic, Cylinder<double>, enclose>(); }

}  // namespace rayproof::render
