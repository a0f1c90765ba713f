#include "viz/scene/film.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rayproof::viz {
namespace {

constexpr int travelling = 2 * film_rate;       ///< pictures of the ray on its way
constexpr int running = film_rate;              ///< pictures of t on its way
constexpr double letters_read = 18;             ///< in a second
constexpr double shortest = 2.5, longest = 10;  ///< seconds to read a caption

int reading_of(const StageStep& step) {
  const double seconds = static_cast<double>(step.caption.size()) / letters_read;
  return static_cast<int>(film_rate * std::clamp(seconds, shortest, longest));
}

/// Points of answers that lie on the slider's line up to t.
Items hits_until(const Stage& stage, double t) {
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

/// Lets the ray's arrow end at p(t).
void shorten_ray(Stage& stage, double t) {
  const glm::dvec3 end = stage.slider->origin + t * stage.slider->direction;
  for (StageItem& item : stage.scene) {
    if (item.role == Role::ray && item.form == Form::arrow) item.points[1] = end;
  }
}

}  // namespace

std::vector<Shot> shots_of(const Stage& stage) {
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

Stage stage_at(const Stage& stage, const Shot& shot) {
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
