#pragma once
/// \file
/// The picture of a ray and a sphere.

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/picture/picture.hpp"

namespace rayproof::viz {

[[nodiscard]] Picture sphere_picture(const Case& one, const Answer* exact, const Answer* claimed);

}  // namespace rayproof::viz
