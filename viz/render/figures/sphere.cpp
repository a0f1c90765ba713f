#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind sphere_figures() { return figure_kind<sphere::Topic>(); }

}  // namespace rayproof::render
