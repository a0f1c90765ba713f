#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind triangle_figures() { return figure_kind<triangle::Topic>(); }

}  // namespace rayproof::render
