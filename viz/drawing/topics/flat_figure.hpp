#pragma once
/// \file
/// Triangles and polygons as they look in space.

#include "viz/drawing/topics/figure.hpp"

namespace rayproof::viz {

/// The sides between the vertices in order, and the vertices by name. `normal` need not be of unit length.
[[nodiscard]] Figure flat_figure(const std::vector<Place>& vertices, const Place& normal,
                                 const std::vector<std::string>& names);

}  // namespace rayproof::viz
