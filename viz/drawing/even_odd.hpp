#pragma once
/// \file
/// Filling polygons that may be concave or cross themselves.

#include <vector>

#include "viz/drawing/view.hpp"

namespace rayproof::viz {

/// Adds what lies inside the polygon by the even-odd rule, and inside the view's frame, as areas that any
/// sink can fill: trapezoids between whole rows of pixels, so that no seam shows between them.
void draw_even_odd(Picture& picture, const View& view, Role role, const std::vector<WorldPoint>& points);

}  // namespace rayproof::viz
