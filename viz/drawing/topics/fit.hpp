#pragma once
/// \file
/// Fitting a flat figure and the ray along y = 0 into a frame.

#include <vector>

#include "viz/drawing/marks.hpp"
#include "viz/drawing/topics/ray_line.hpp"

namespace rayproof::viz {

/// The smallest upright rectangle around points.
struct Extent {
  Shadow left, right, bottom, top;
  [[nodiscard]] static Extent of(const std::vector<WorldPoint>& points);
  [[nodiscard]] Shadow half_size() const;
  void include(const WorldPoint& p);
};

/// A view, and what did not fit into it.
struct Fitted {
  View view;
  bool leaves_start_out = false;  ///< beyond a break in the axis
  bool leaves_ray_out = false;    ///< the whole line passes too far off
};
/// Shows the figure, the line, the hits near the figure and the ray's start, as far as the figure does not
/// become a speck by it.
[[nodiscard]] Fitted fit(const PixelBox& frame, const Extent& figure, const RayLine& ray,
                         const std::vector<NamedMark>& hits);

}  // namespace rayproof::viz
