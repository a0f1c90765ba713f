#pragma once
/// \file
/// What a picture of a ray and a figure has to show, from which side, and from how near.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/answer.hpp"
#include "viz/drawing/marks.hpp"
#include "viz/drawing/topics/figure.hpp"
#include "viz/drawing/topics/fit.hpp"
#include "viz/drawing/topics/ray_line.hpp"

namespace rayproof::viz {

/// The question in the world, with everybody's hits.
struct WireframeScene {
  Sight sight;
  Figure figure;
  Place along_ray;  ///< the direction, of unit length
  Shadow direction_size;
  const Answer* exact;
  const Answer* claimed;

  [[nodiscard]] Place at(const Shadow& t) const { return point_at(sight.ray, t); }
  [[nodiscard]] std::vector<NamedMark> marks(const ViewCamera& camera) const;
  [[nodiscard]] RayLine line(const ViewCamera& camera) const;
  [[nodiscard]] ViewCamera main_camera() const;
};
[[nodiscard]] WireframeScene scene_of(Figure (*maker)(const Sight&), const Case& one, const Answer* exact,
                                      const Answer* claimed);

/// Where the ray's line passes nearest to the outline.
struct NearestPass {
  Place on_ray, on_outline;
  Place side;  ///< the outline's direction there, of unit length or 0
  Shadow gap;
};
[[nodiscard]] std::optional<NearestPass> nearest_of(const WireframeScene& scene);

/// A look through the magnifying glass, from a side of its own.
struct WireframeInset {
  ViewCamera camera;
  View view;
  Place middle;  ///< what it looks at
  std::optional<std::pair<WorldPoint, WorldPoint>> measured{};
  std::string label{};
  std::optional<std::pair<Place, Place>> surface{};  ///< where it cuts the surface that is hit
};
/// Nothing where the main view shows everything.
[[nodiscard]] std::optional<WireframeInset> inset_of(const WireframeScene& scene, const ViewCamera& camera,
                                                     const View& main, const PixelBox& frame);

}  // namespace rayproof::viz
