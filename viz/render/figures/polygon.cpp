#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind polygon_figures() { return figure_kind<polygon::Topic>(); }

}  // namespace rayproof::render
