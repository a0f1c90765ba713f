#pragma once
/// \file
/// The picture of a quadratic equation: the parabola and where it meets the axis.

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/picture/picture.hpp"

namespace rayproof::viz {

[[nodiscard]] Picture quadratic_picture(const Case& one, const Answer* exact, const Answer* claimed);

}  // namespace rayproof::viz
