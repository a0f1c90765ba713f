#pragma once
/// \file
/// The strategies of the library as data: each places the origin of the ray that leaves a situation.

#include "properties/leaving/situation.hpp"

namespace rayproof::leaving {

struct Strategy {
  std::string name;
  std::string title;
  Source source{};
  bool is_proven = false;
  bool moves_to_surface = false;  ///< starts from the point moved onto the surface, not from the hit
  /// Computed in the situation's own precision.
  glm::dvec3 (*origin)(const Situation&) = nullptr;
};

/// Every strategy, in the order of the library's list.
[[nodiscard]] const std::vector<Strategy>& strategies();

/// The ray that a strategy starts. Its direction, turned round where need be, leaves the surface at the foot
/// of the point from which the strategy starts, by its exact sign.
[[nodiscard]] RayQuestion next_ray(const Strategy& strategy, const Situation& from, const glm::dvec3& origin);

/// What becomes of that ray.
[[nodiscard]] oracle::Departure depart(const Strategy& strategy, const Situation& from,
                                       const glm::dvec3& origin);

/// Whether that is a failure to show: a false hit of any strategy, or no origin at all; what is skipped only
/// of one that is proven, since the others promise nothing of what is thinner than their offset.
[[nodiscard]] bool is_failure(const Strategy& strategy, oracle::Departure departure);

}  // namespace rayproof::leaving
