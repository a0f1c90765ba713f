#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {
namespace {

void enclose(Hull& hull, const Triangle<double>& triangle) {
  for (const glm::dvec3& vertex : {triangle.a, triangle.b, triangle.c}) hull.add(Point::from(vertex));
}

}  // namespace

FigureKind triangle_figures() { return figure_kind<triangle::Topic, Triangle<double>, enclose>(); }

}  // namespace rayproof::render
