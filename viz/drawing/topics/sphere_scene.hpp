#pragma once
/// \file
/// What a picture of ray and sphere has to show, and from how near.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "case/answer.hpp"
#include "viz/drawing/marks.hpp"
#include "viz/drawing/topics/ray_plane.hpp"

namespace rayproof::viz {

/// The question in its plane, with everybody's hits.
struct SphereScene {
  RayPlane plane;
  Ray<double> ray;
  std::vector<NamedMark> hits;
  bool verdicts_differ = false;
  /// The farthest apart of an exact hit and the claimed one; nothing where they agree or can't be paired.
  std::optional<std::pair<WorldPoint, WorldPoint>> worst;

  [[nodiscard]] bool has_start() const { return std::isfinite(ray.t_min); }
  [[nodiscard]] bool has_end() const { return std::isfinite(ray.t_max); }
  [[nodiscard]] WorldPoint start() const { return plane.at(ray.t_min); }
  [[nodiscard]] WorldPoint end() const { return plane.at(ray.t_max); }
  [[nodiscard]] Shadow farthest_claimed() const;
};
[[nodiscard]] SphereScene scene_of(const Case& one, const Answer* exact, const Answer* claimed);

/// The sphere and the ray's start at one scale, or, where the sphere would be a speck then, the sphere alone.
struct MainView {
  View view;
  bool is_broken = false;  ///< the ray's start lies outside, beyond a break in the axis
};
[[nodiscard]] MainView main_view(const SphereScene& scene, const PixelBox& frame);

/// A look through the magnifying glass: at an error, or at the gap between the line and the sphere.
struct Inset {
  View view;
  std::optional<std::pair<WorldPoint, WorldPoint>> measured;  ///< the ends of the length to be labelled
  std::string label;
};
/// Nothing where the main view shows everything.
[[nodiscard]] std::optional<Inset> inset_of(const SphereScene& scene, const View& main,
                                            const PixelBox& frame);

}  // namespace rayproof::viz
