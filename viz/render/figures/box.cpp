#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {
namespace {

void enclose(Hull& hull, const rayproof::Box<double>& box) {
  hull.add_box(Point::from(box.min), Point::from(box.max));
}

}  // namespace

FigureKind box_figures() { return figure_kind<box::Topic, rayproof::Box<double>, enclose>(); }

}  // namespace rayproof::render
