#include <algorithm>
#include <array>

#include "viz/player/player.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

constexpr double slider_part = 0.02;

bool is_one_of(const std::string& key, std::initializer_list<const char*> names) {
  return std::ranges::any_of(names, [&](const char* name) { return key == name; });
}

/// The step that a key of digits names, from 0; -1 for any other key.
int step_of(const std::string& key) {
  const bool is_number =
      !key.empty() && key.size() < 4 && std::ranges::all_of(key, [](char c) { return c >= '0' && c <= '9'; });
  return is_number ? std::stoi(key) - 1 : -1;
}

struct Help {
  const char* keys;
  const char* what;
};

constexpr std::array help{
    Help{"← →  Page up, Page down", "the step before, the next"},
    Help{"Home  End  1 … 9", "the first step, the last, that one"},
    Help{"↑ ↓  + −", "move the point along the ray; or drag the slider"},
    Help{",  .  [  ]", "to the neighbouring number: the smallest change of t there is"},
    Help{"Tab", "what the arrow keys move: the steps, the slider, the view, then each handle"},
    Help{"Drag a ball",
         "moves the ray's origin or its tip, or what defines the shape; all is computed again"},
    Help{"Drag elsewhere",
         "looks from another side, as does a click on an axis of the compass; with Shift it shifts"},
    Help{"Wheel", "nearer, farther; + − while the arrow keys move the view"},
    Help{"r", "everything as it was at first"},
    Help{"c", "print the case as it stands, for any program that reads cases"},
    Help{"s", "save the window's picture as a PNG, where the program was started"},
    Help{"n  p", "the next walkthrough, the one before, where there are several"},
    Help{"h  F1  ?", "this page; Esc closes it"},
    Help{"q", "quit"},
};

}  // namespace

void Player::move_focus(bool is_backward) {
  std::vector<std::pair<Focus, std::string>> order{{Focus::steps, ""}};
  if (stage_.slider) order.emplace_back(Focus::slider, "");
  if (!stage_.camera.is_flat) order.emplace_back(Focus::view, "");
  for (const Handle& handle : handles()) order.emplace_back(Focus::handle, handle.name);
  const auto at = std::ranges::find(order, std::pair(focus_, focused_)) - order.begin();
  const std::size_t next = static_cast<std::size_t>(at) + (is_backward ? order.size() - 1 : 1);
  const auto& [focus, handle] = order[next % order.size()];
  put_focus(focus, handle);
}

Request Player::press_arrow(const std::string& key) {
  const double right = key == "Right" ? 1 : key == "Left" ? -1 : 0;
  const double up = key == "Up" ? 1 : key == "Down" ? -1 : 0;
  if (right == 0 && up == 0) return Request::none;
  if (focus_ == Focus::view || focus_ == Focus::handle) return Request::move_focused;
  if (focus_ == Focus::slider) {
    move_slider((right + up) * slider_part);
  } else {
    if (right > 0) go_to(step_ + 1);
    if (right < 0 && step_ > 0) go_to(step_ - 1);
    move_slider(up * slider_part);
  }
  return Request::none;
}

Request Player::press_key(const std::string& key, bool is_shifted) {
  release();  // what is held may be gone after the key
  if (is_one_of(key, {"q", "Q"})) return Request::quit;
  if (key == "c") return Request::print_case;
  if (key == "s") return Request::save_picture;
  if (is_one_of(key, {"h", "H", "F1", "question", "slash"})) {
    is_help_shown_ = !is_help_shown_;
    return Request::none;
  }
  if (key == "Escape") {
    if (!is_help_shown_) put_focus(Focus::steps);
    is_help_shown_ = false;
    return Request::none;
  }
  const std::size_t last = stage_.steps.size() - 1;
  const int number = step_of(key);
  if (is_one_of(key, {"Tab", "ISO_Left_Tab"})) move_focus(is_shifted || key == "ISO_Left_Tab");
  if (is_one_of(key, {"Next", "space"})) go_to(step_ + 1);
  if (is_one_of(key, {"Prior", "BackSpace"})) go_to(step_ > 0 ? step_ - 1 : 0);
  if (key == "Home") go_to(0);
  if (key == "End") go_to(last);
  if (number >= 0 && static_cast<std::size_t>(number) <= last) go_to(static_cast<std::size_t>(number));
  const double more = is_one_of(key, {"plus", "equal", "KP_Add"})              ? 1
                      : is_one_of(key, {"minus", "underscore", "KP_Subtract"}) ? -1
                                                                               : 0;
  if (more != 0 && focus_ == Focus::view) return more > 0 ? Request::nearer : Request::farther;
  if (more != 0) move_slider(more * slider_part);
  if (is_one_of(key, {"period", "bracketright"})) set_t(neighbour_of(t_, 1, stage_.precision));
  if (is_one_of(key, {"comma", "bracketleft"})) set_t(neighbour_of(t_, -1, stage_.precision));
  if (is_one_of(key, {"r", "R"})) {
    reset();
    return Request::look_anew;
  }
  if (key == "n" && play_ + 1 < plays_.size()) show_play(play_ + 1);
  if (key == "p" && play_ > 0) show_play(play_ - 1);
  return press_arrow(key);
}

Picture help_picture(const Stage& stage) {
  constexpr double column = 260;
  Picture picture{slide_width, slide_height, stage.title, "What the keys and the mouse do."};
  add_text(picture, Role::text, {slide_margin, 44}, "What the keys and the mouse do", 22, true);
  double y = 80;
  for (const Help& one : help) {
    add_text(picture, Role::text, {slide_margin, y}, one.keys, 14, true);
    add_text(picture, Role::text, {column, y}, one.what, 14, false);
    y += 28;
  }
  add_text(
      picture, Role::muted, {slide_margin, y + 8},
      "The numbers are the run's own: each drag makes a case and runs the method and the exact answer on "
      "it again.",
      13, false);
  return picture;
}

}  // namespace rayproof::viz
