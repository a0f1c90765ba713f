#pragma once
/// \file
/// What a polygon that crosses itself fills, by the even-odd rule.

#include <array>
#include <vector>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// Four corners in turn; two of them may be one.
using Strip = std::array<Point, 4>;

/// The inside in level strips; none of a ring no two of whose sides cross.
[[nodiscard]] std::vector<Strip> even_odd_strips(const std::vector<Point>& ring);

}  // namespace rayproof::viz
