#pragma once
/// \file
/// The view that just holds what there is to see.

#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// The point of an ellipsoid that lies farthest in a direction.
[[nodiscard]] glm::dvec3 farthest_of(const StageItem& ellipsoid, const glm::dvec3& direction);

/// How far an item reaches: its points, and of an ellipsoid the points of its outline that lie farthest to
/// each side as the camera sees it.
[[nodiscard]] std::vector<glm::dvec3> extent_of(const StageItem& item, const StageCamera& camera);

/// How far all of them reach.
[[nodiscard]] std::vector<glm::dvec3> extent_of(const std::vector<StageItem>& items,
                                                const StageCamera& camera);

/// The smallest view that holds the points as the camera sees them; those that are not finite are left out.
[[nodiscard]] StageView view_of(const std::vector<glm::dvec3>& points, const StageCamera& camera);

/// The radius that a view of this centre needs to hold the items.
[[nodiscard]] double radius_for(const StageView& view, const std::vector<StageItem>& items,
                                const StageCamera& camera);

}  // namespace rayproof::viz
