#pragma once
/// \file
/// From where a step is seen in space.

#include <glm/vec3.hpp>
#include <vector>

#include "viz/scene/shown_items.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// How far around the view things are built, in its radii.
inline constexpr double reach = 6;
/// Degrees, from top to bottom of what the eye sees.
inline constexpr double view_angle = 24;
/// How much more than a view's radius is seen above and below: room for marks and labels.
inline constexpr double view_margin = 1.14;

/// An eye above a floor, or straight before a drawing in a plane. All coordinates are of the view: its centre
/// is 0, its radius 1.
struct SpaceCamera {
  glm::dvec3 up{};       ///< z, for a ray along z the y axis; of a drawing its own up
  glm::dvec3 toward{};   ///< from the scene to the eye, a unit vector
  glm::dvec3 middle{};   ///< where the eye looks
  double distance = 1;   ///< of the eye from there
  double half = 1;       ///< of a drawing, how much is seen above the middle and below it
  bool is_flat = false;  ///< without perspective

  /// What is of this size in the middle looks as large as 1 does where the view just fits.
  [[nodiscard]] double unit() const;
  [[nodiscard]] glm::dvec3 eye() const { return middle + distance * toward; }
  /// Between these distances from the eye, things are seen.
  [[nodiscard]] double nearest() const { return 0.2 * distance; }
  [[nodiscard]] double farthest() const { return distance + 2 * reach; }
};

/// A point of the world in the view's coordinates.
[[nodiscard]] inline glm::dvec3 in_view(const StageView& view, const glm::dvec3& p) {
  return (p - view.centre) / view.radius;
}

/// Near enough that what the step's own view shows just fits into a frame `aspect` times as wide as high.
[[nodiscard]] SpaceCamera space_camera(const Stage& stage, std::size_t step,
                                       const std::vector<ShownItem>& shown, double aspect = view_aspect);

}  // namespace rayproof::viz
