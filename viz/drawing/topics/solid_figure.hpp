#pragma once
/// \file
/// Boxes and parallelepipeds as they look in space.

#include <array>

#include "viz/drawing/topics/figure.hpp"

namespace rayproof::viz {

/// Twelve edges, those behind the solid hidden. Edges of length 0 are allowed.
[[nodiscard]] Figure solid_figure(const Place& corner, const std::array<Place, 3>& edges);

}  // namespace rayproof::viz
