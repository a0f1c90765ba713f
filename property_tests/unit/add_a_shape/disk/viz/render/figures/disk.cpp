#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind disk_figures() { return figure_kind<disk::Topic>(); }

}  // namespace rayproof::render
