#pragma once
/// \file
/// From the world of a stage to a frame of a picture, without perspective.

#include <vector>

#include "viz/picture/picture.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Shows a view's ball, whole, in the middle of a frame.
struct ScreenProjection {
  StageCamera camera{};
  StageView view{};
  PixelBox frame{};

  [[nodiscard]] Point to_pixels(const glm::dvec3& p) const;
  [[nodiscard]] std::vector<Point> to_pixels(const std::vector<glm::dvec3>& points) const;
  [[nodiscard]] double pixels_per_length() const;
};

/// The outline of an ellipsoid (its centre and the tips of three conjugate semi-axes) as it is seen.
[[nodiscard]] std::vector<Point> ellipsoid_outline(const ScreenProjection& projection,
                                                   const std::vector<glm::dvec3>& ellipsoid);

/// The convex hull of points in a picture.
[[nodiscard]] std::vector<Point> hull_outline(const std::vector<Point>& points);

}  // namespace rayproof::viz
