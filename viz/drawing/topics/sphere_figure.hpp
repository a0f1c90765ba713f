#pragma once
/// \file
/// Spheres, and the ellipsoids that transforms make of them, as they look in space.

#include "viz/drawing/topics/figure.hpp"

namespace rayproof::viz {

[[nodiscard]] Figure sphere_figure(const Sight& sight);

}  // namespace rayproof::viz
