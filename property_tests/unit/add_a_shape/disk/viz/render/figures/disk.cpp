#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {
namespace {

void enclose(Hull& hull, const Disk<double>& disk) {
  const auto center = Point::from(disk.center);
  const auto reach = Point::from(glm::dvec3(disk.radius));
  hull.add_box(center - reach, center + reach);
}

}  // namespace

FigureKind disk_figures() { return figure_kind<disk::Topic, Disk<double>, enclose>(); }

}  // namespace rayproof::render
