#pragma once
/// \file
/// Where a run computes, if not in the world: the shape's own space, the sheared space, a projection.

#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// From the plane of a drawing to the plane of the screen.
[[nodiscard]] std::function<glm::dvec3(const glm::dvec3&)> flat_on(const StageCamera& camera);

/// The point's projection along the largest axis of `n`, as the kernels have it.
[[nodiscard]] glm::dvec3 dropped(const glm::dvec3& n, const glm::dvec3& p);

/// The space that step `index` of the run computes in; null for the world.
[[nodiscard]] const StepSpace* space_of(const Setting& setting, const Walkthrough& walk, std::size_t index);

/// The setting with what the space has of its own.
[[nodiscard]] Setting in_space(Setting setting, const StepSpace& space);

/// The spaces in which the methods of triangles compute.
[[nodiscard]] std::vector<StepSpace> triangle_spaces(const Walkthrough& walk, const StageCamera& camera);

/// Lets a step show its space: the scene there, what earlier steps showed there in grey, and its own items.
/// `earlier` then has those, too.
void show_in_space(StageStep& step, const StepSpace& space, const NumbersByName& n, const StageCamera& camera,
                   Items& earlier);

}  // namespace rayproof::viz
