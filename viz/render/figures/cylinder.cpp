#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind cylinder_figures() { return figure_kind<cylinder::Topic>(); }

}  // namespace rayproof::render
