#pragma once
/// \file
/// The picture of a point and a polygon, and of the sides that a ray to the right crosses.

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/picture/picture.hpp"

namespace rayproof::viz {

[[nodiscard]] Picture point_in_polygon_picture(const Case& one, const Answer* exact, const Answer* claimed);

}  // namespace rayproof::viz
