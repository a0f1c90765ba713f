#include "viz/player/player_layout.hpp"

#include <algorithm>

namespace rayproof::viz {
namespace {

constexpr double row_top = controls_top + 10;
constexpr double button_height = 28;
constexpr double button_gap = 4;
constexpr double square_button = 32;

}  // namespace

std::vector<Button> buttons_of(const ButtonState& state) {
  std::vector<Button> buttons;
  double x = slide_margin;
  // Many steps share the room that is left of the buttons at the right.
  const double room = (state.stage_count > 1 ? 560.0 : 640.0) / (static_cast<double>(state.step_count) + 2);
  const double step_width = std::min(square_button, room - button_gap);
  const auto add = [&](const std::string& text, const std::string& key, double width) -> Button& {
    buttons.push_back({{x, row_top, width, button_height}, text, key});
    x += width + button_gap;
    return buttons.back();
  };
  add("◀", "Left", step_width).is_enabled = state.step > 0;
  for (std::size_t i = 0; i < state.step_count; ++i) {
    const std::string number = std::to_string(i + 1);
    add(number, number, step_width).is_current = i == state.step;
  }
  add("▶", "Right", step_width).is_enabled = state.step + 1 < state.step_count;

  constexpr double wide = 72;
  const double right =
      3 * wide + 2 * button_gap + (state.stage_count > 1 ? 2 * (square_button + button_gap) : 0);
  x = player_width - slide_margin - right;
  if (state.stage_count > 1) {
    add("«", "p", square_button).is_enabled = state.stage > 0;
    add("»", "n", square_button).is_enabled = state.stage + 1 < state.stage_count;
  }
  add("Reset r", "r", wide);
  add("Help h", "h", wide).is_current = state.is_help_shown;
  add("Quit q", "q", wide);
  return buttons;
}

double x_on_track(const StageSlider& slider, double t) {
  const double part = std::clamp((t - slider.from) / (slider.to - slider.from), 0.0, 1.0);
  return slider_track.left + part * slider_track.width;
}

double t_on_track(const StageSlider& slider, double x) {
  const double part = std::clamp((x - slider_track.left) / slider_track.width, 0.0, 1.0);
  return std::clamp(slider.from + part * (slider.to - slider.from), slider.from, slider.to);
}

}  // namespace rayproof::viz
