#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind plane_figures() { return figure_kind<plane::Topic>(); }

}  // namespace rayproof::render
