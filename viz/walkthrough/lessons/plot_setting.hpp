#pragma once
/// \file
/// The place of lessons that are drawings in a plane.

#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// A drawing in the plane of the screen, of its own scene.
[[nodiscard]] inline Setting plot_setting(const CaseReport& report) {
  Setting setting = setting_of(report);
  setting.camera = {};
  setting.camera.is_flat = true;
  setting.scene.clear();
  setting.near = setting.wide = {{0, 0, 0}, 0.8};
  setting.to_world = [](const glm::dvec3& p) { return p; };
  return setting;
}

}  // namespace rayproof::viz
