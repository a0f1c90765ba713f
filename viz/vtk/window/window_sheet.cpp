#include <fmt/format.h>

#include <algorithm>

#include "viz/flat/stage_picture.hpp"
#include "viz/player/player.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/vtk/window/stage_window.hpp"
#include "viz/vtk/window/widgets.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

constexpr double row_top = slide_height - 28;
constexpr double button_height = 24;
constexpr double button_gap = 4;
constexpr double square_button = 32;
constexpr double wide_button = 68;

constexpr double rounded_column = 140;
constexpr double exact_column = 430;
constexpr double row = 17;

/// t before the slider's track, its range at the track's ends, and below it what changes with t.
void write_live_values(Picture& sheet, const StageSlider& slider, double t, Precision precision) {
  const double y = slider_track.centre().y + 5;
  add_text(sheet, Role::text, {slide_margin, y}, fmt::format("{} = {}", slider.symbol, shown(t, precision)),
           16, true);
  add_text(sheet, Role::muted, {slider_track.left - 8, y}, rough(slider.from), 12, false, Anchor::end);
  add_text(sheet, Role::muted, {slider_track.right() + 8, y}, rough(slider.to), 12);
  double below = y + 4;
  for (const LiveValue& value : live_values(slider, t, precision)) {
    below += row;
    add_text(sheet, Role::text, {slide_margin, below}, value.label, 13, true);
    add_text(sheet, Role::claimed, {rounded_column, below}, value.rounded, 13);
    if (!value.exact.empty())
      add_text(sheet, Role::exact, {exact_column, below}, "exact " + value.exact, 12.5);
  }
}

std::string focus_in_words(const Player& player) {
  switch (player.focus()) {
    case Focus::steps:
      return player.stage().title;
    case Focus::slider:
      return "The arrow keys move the slider (Tab: the next).";
    case Focus::view:
      return "The arrow keys turn the view (Tab: the next).";
    case Focus::handle:
      break;
  }
  return fmt::format("The arrow keys move: {} (Tab: the next).", player.focused_handle());
}

}  // namespace

std::vector<Button> buttons_of(const Player& player) {
  std::vector<Button> buttons;
  const std::size_t count = player.stage().steps.size();
  const bool has_others = player.play_count() > 1;
  double x = slide_margin;
  // Many steps share the room that is left of the buttons at the right.
  const double room = (has_others ? 590.0 : 670.0) / (static_cast<double>(count) + 2);
  const double step_width = std::min(square_button, room - button_gap);
  const auto add = [&](const std::string& text, const std::string& key, double width) -> Button& {
    buttons.push_back({{x, row_top, width, button_height}, text, key});
    x += width + button_gap;
    return buttons.back();
  };
  add("◀", "Left", step_width).is_enabled = player.step() > 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string number = std::to_string(i + 1);
    add(number, number, step_width).is_current = i == player.step();
  }
  add("▶", "Right", step_width).is_enabled = player.step() + 1 < count;
  x = slide_width - slide_margin - 3 * wide_button - 2 * button_gap;
  if (has_others) {
    x -= 2 * (square_button + button_gap);
    add("«", "p", square_button).is_enabled = player.play() > 0;
    add("»", "n", square_button).is_enabled = player.play() + 1 < player.play_count();
  }
  add("Reset r", "r", wide_button);
  add("Help h", "h", wide_button).is_current = player.is_help_shown();
  add("Quit q", "q", wide_button);
  return buttons;
}

void draw_buttons(Picture& sheet, const std::vector<Button>& buttons) {
  for (const Button& button : buttons) {
    const PixelBox& box = button.box;
    add_frame(sheet, button.is_current ? Role::text : Role::frame, box, button.is_current ? 2.5 : 1.2);
    const double size = box.width < 24 ? 11 : 14;
    add_text(sheet, button.is_enabled ? Role::text : Role::frame,
             {box.centre().x, box.centre().y + size * 0.36}, button.text, size, button.is_current,
             Anchor::middle);
  }
}

Picture window_sheet(const Player& player) {
  const bool is_refused = !player.complaint().empty();
  if (player.is_help_shown()) return help_picture(player.stage());
  Picture sheet =
      slide_frame(player.stage(), player.step(), is_refused ? "" : focus_in_words(player), window_scene);
  if (is_refused) {
    const double room = slide_width - 2 * slide_margin;
    add_text(sheet, Role::claimed, {slide_margin, 54}, cut(player.complaint(), room, 13), 13, true);
  }
  if (const auto& slider = player.stage().slider)
    write_live_values(sheet, *slider, player.t(), player.stage().precision);
  return sheet;
}

}  // namespace rayproof::viz
