#pragma once
/// \file
/// The point that runs along the ray.

#include <fmt/format.h>

#include "viz/scene/items.hpp"

namespace rayproof::viz {

/// Puts p(t) among the items of a step, where its scene is that of the slider.
inline void add_runner(Stage& stage, std::size_t step, double t) {
  StageStep& shown = stage.steps.at(step);
  if (!stage.slider || shown.is_apart) return;
  const StageSlider& slider = *stage.slider;
  shown.items.push_back(
      point(Role::ray, slider.origin + t * slider.direction, fmt::format("{} = {:.4g}", slider.symbol, t)));
}

}  // namespace rayproof::viz
