#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind box_figures() { return figure_kind<box::Topic>(); }

}  // namespace rayproof::render
