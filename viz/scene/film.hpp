#pragma once
/// \file
/// A stage as a film: what each of its pictures shows, and for how long.

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
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

inline constexpr int travelling = 2 * film_rate;       ///< pictures of the ray on its way
inline constexpr int running = film_rate;              ///< pictures of t on its way
inline constexpr double letters_read = 18;             ///< in a second
inline constexpr double shortest = 2.5, longest = 10;  ///< seconds to read a caption

[[nodiscard]] inline int reading_of(const StageStep& step) {
  const double seconds = static_cast<double>(step.caption.size()) / letters_read;
  return static_cast<int>(film_rate * std::clamp(seconds, shortest, longest));
}

/// Points of answers that lie on the slider's line up to t.
[[nodiscard]] inline Items hits_until(const Stage& stage, double t) {
  const StageSlider& slider = *stage.slider;
  const double square = glm::dot(slider.direction, slider.direction);
  Items hits;
  for (const StageStep& step : stage.steps) {
    if (step.is_apart) continue;
    for (const StageItem& item : step.items) {
      const bool is_answer = item.role == Role::claimed || item.role == Role::exact;
      if (item.form != Form::point || !is_answer) continue;
      const double at = glm::dot(item.points[0] - slider.origin, slider.direction) / square;
      const glm::dvec3 off = slider.origin + at * slider.direction - item.points[0];
      if (at <= t && glm::length(off) < 1e-3 * step.view.radius) hits.push_back(item);
    }
  }
  return hits;
}

inline void shorten_ray(Stage& stage, double t) {
  const glm::dvec3 end = stage.slider->origin + t * stage.slider->direction;
  for (StageItem& item : stage.scene) {
    if (item.role == Role::ray && item.form == Form::arrow) item.points[1] = end;
  }
}

/// In the first step the ray travels and leaves a light where it meets something; in each step t runs to the
/// first hit, and then there is time to read.
[[nodiscard]] inline std::vector<Shot> shots_of(const Stage& stage) {
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    if (stage.slider && !stage.steps[i].is_apart) {
      const StageSlider& slider = *stage.slider;
      const bool is_first = i == 0;
      const int count = is_first ? travelling : running;
      const double to = is_first ? slider.to : slider.start;
      for (int k = 0; k < count; ++k)
        shots.push_back({i, slider.from + (to - slider.from) * k / count, is_first, 1});
    }
    shots.push_back({i, stage.slider ? stage.slider->start : 0, false, reading_of(stage.steps[i])});
  }
  return shots;
}

/// Puts p(t) among the items of a step, where its scene is that of the slider.
inline void add_runner(Stage& stage, std::size_t step, double t) {
  StageStep& shown = stage.steps.at(step);
  if (!stage.slider || shown.is_apart) return;
  const StageSlider& slider = *stage.slider;
  shown.items.push_back(
      point(Role::ray, slider.origin + t * slider.direction, fmt::format("{} = {:.4g}", slider.symbol, t)));
}

/// The stage with a shot's step as the shot shows it.
[[nodiscard]] inline Stage stage_at(const Stage& stage, const Shot& shot) {
  Stage shown = stage;
  if (stage.slider && shot.step == 0 && !stage.steps[0].is_apart) {
    const Items hits = hits_until(stage, shot.is_arrival ? shot.t : stage.slider->to);
    Items& items = shown.steps[0].items;
    items.insert(items.end(), hits.begin(), hits.end());
    if (shot.is_arrival) shorten_ray(shown, shot.t);
  }
  add_runner(shown, shot.step, shot.t);
  return shown;
}

}  // namespace rayproof::viz
