#pragma once
/// \file
/// What a verdict hangs on, magnified: how near a ray passes by an outline, and a point by a polygon's side.

#include "viz/shapes/ray_scene.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// What is shown of it, in gaps from the outline: surfaces run out of the view.
inline constexpr StageView close_up_view{{0, 0, 0}, 2.3};

/// The ray and what lies below it in profile: a face, a solid's edge, or a round side that looks level; with
/// both answers' hits that are near.
[[nodiscard]] std::optional<CloseUp> close_up_of(const RayScene& scene, const CaseReport& report,
                                                 const StageCamera& camera);

/// A point and the sides of a polygon that are nearest to it.
[[nodiscard]] CloseUp close_up_of(const std::vector<glm::dvec3>& ring, const glm::dvec3& p);

}  // namespace rayproof::viz
