#pragma once
/// \file
/// A stage as a film: what each of its pictures shows, and for how long.

#include <fmt/format.h>

#include <vector>

#include "viz/scene/items.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

inline constexpr int film_rate = 8;

struct Shot {
  std::size_t step = 0;
  double t = 0;             ///< where p(t) is, where the step shows it
  bool is_arrival = false;  ///< the ray has come as far as p(t), and no farther
  int count = 1;            ///< for how many pictures of the film it stays
};

/// In the first step the ray travels and leaves a light where it meets something; in each step t runs to the
/// first hit, and then there is time to read.
[[nodiscard]] std::vector<Shot> shots_of(const Stage& stage);

/// The stage with a shot's step as the shot shows it.
[[nodiscard]] Stage stage_at(const Stage& stage, const Shot& shot);

/// Puts p(t) among the items of a step, where its scene is that of the slider.
inline void add_runner(Stage& stage, std::size_t step, double t) {
  StageStep& shown = stage.steps.at(step);
  if (!stage.slider || shown.is_apart) return;
  const StageSlider& slider = *stage.slider;
  shown.items.push_back(
      point(Role::ray, slider.origin + t * slider.direction, fmt::format("{} = {:.4g}", slider.symbol, t)));
}

}  // namespace rayproof::viz
