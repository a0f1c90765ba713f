#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {
namespace {

void enclose(Hull& hull, const Sphere<double>& sphere) {
  const auto center = Point::from(sphere.center);
  const auto reach = Point::from(glm::dvec3(sphere.radius));
  hull.add_box(center - reach, center + reach);
}

}  // namespace

FigureKind sphere_figures() { return figure_kind<sphere::Topic, Sphere<double>, enclose>(); }

}  // namespace rayproof::render
