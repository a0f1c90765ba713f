#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {

FigureKind parallelepiped_figures() { return figure_kind<parallelepiped::Topic>(); }

}  // namespace rayproof::render
