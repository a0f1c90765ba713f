#pragma once
/// \file
/// The scenes of questions about no shape in space: an equation's parabola, a point and a polygon.

#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

[[nodiscard]] Setting flat_setting(const CaseReport& report);

/// The height of an equation's drawing, whose x goes from -1 to 1.
inline constexpr double plot_height = 1.2;

/// How an equation's numbers are put into its drawing: x from `left` to `right` becomes -1 to 1, and y from
/// its least to its greatest value, `height` more, takes up the drawing's height.
struct ParabolaFrame {
  double left = -1, right = 1, height = 1;
  [[nodiscard]] glm::dvec3 at(double x, double y) const {
    return {(2 * x - left - right) / (right - left), plot_height * y / height, 0};
  }
};
[[nodiscard]] ParabolaFrame parabola_frame(const Quadratic<double>& equation,
                                           const std::vector<double>& roots);

}  // namespace rayproof::viz
