#pragma once
/// \file
/// A method's errors over a surface, as colours on it.

#include <functional>
#include <glm/vec3.hpp>
#include <string>

#include "case/case.hpp"
#include "viz/picture/raster.hpp"

namespace rayproof::render {

/// How far off a ray's answer is that is aimed at a place of the surface, in ulps; negative where its verdict
/// is wrong.
using ErrorAt = std::function<double(const glm::dvec3& place)>;

struct HeatWords {
  std::string title{};
  std::string caption{};
};

struct HeatTotals {
  std::size_t rays = 0;
  std::size_t wrong = 0;
  double worst_ulps = 0;  ///< where the verdict is right
};

/// Whether a shape's surface can be shown so: a sphere's or a triangle's.
[[nodiscard]] bool has_heat_map(const Shape& shape);

/// The surface in 1600 by 900 pixels, seen from near the eye; the side of a sphere that the eye does not see
/// stays grey. One ray is asked for each of its small faces. `words` is asked once all errors are known.
/// Needs a display (viz::OffscreenDisplay).
[[nodiscard]] viz::Raster heat_map(const Shape& shape, const glm::dvec3& eye, const ErrorAt& error_at,
                                   const std::function<HeatWords(const HeatTotals&)>& words);

}  // namespace rayproof::render
