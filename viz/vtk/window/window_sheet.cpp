#include "viz/vtk/window/stage_window.hpp"

#include <fmt/format.h>

#include "viz/flat/stage_picture.hpp"
#include "viz/player/player.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

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
