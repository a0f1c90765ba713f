#pragma once
/// \file
/// Where the parts of the interactive walkthrough lie: a slide above, the controls below.

#include <string>
#include <vector>

#include "viz/flat/stage_picture.hpp"
#include "viz/picture/picture.hpp"

namespace rayproof::viz {

inline constexpr double player_width = 960;
inline constexpr double player_height = 716;
/// The slide's own height; the controls begin below it.
inline constexpr double controls_top = 540;
inline constexpr PixelBox slider_track{214, 590, 716, 24};

/// A button stands for a key, so that whatever can be clicked can be typed.
struct Button {
  PixelBox box{};
  std::string text;
  std::string key;
  bool is_current = false;
  bool is_enabled = true;
};

/// What the buttons depend on.
struct ButtonState {
  std::size_t step = 0;
  std::size_t step_count = 1;
  std::size_t stage = 0;
  std::size_t stage_count = 1;
  bool is_help_shown = false;
};

/// A row of buttons: back, each step, forth, and at the right the other walkthroughs, reset, help and quit.
[[nodiscard]] std::vector<Button> buttons_of(const ButtonState& state);

/// Between t and the slider's track.
[[nodiscard]] double x_on_track(const StageSlider& slider, double t);
[[nodiscard]] double t_on_track(const StageSlider& slider, double x);

}  // namespace rayproof::viz
