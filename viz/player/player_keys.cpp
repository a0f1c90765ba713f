/// \file
/// What the keys do.

#include <algorithm>
#include <array>

#include "viz/flat/orbit.hpp"
#include "viz/player/player.hpp"
#include "viz/walkthrough/live_values.hpp"

namespace rayproof::viz {
namespace {

constexpr std::array all_focuses{Focus::steps, Focus::slider, Focus::view, Focus::origin, Focus::tip};
constexpr double slider_part = 0.02;
constexpr double turn = 0.1;         // radians
constexpr double handle_pixels = 8;  // of the slide

bool is_one_of(const std::string& key, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return key == name; });
}

/// The step that a key of digits names, from 0; -1 for any other key.
int step_of(const std::string& key) {
  const bool is_number = !key.empty() && key.size() < 4 &&
                         std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_number ? std::stoi(key) - 1 : -1;
}

}  // namespace

bool Player::can_focus(Focus focus) const {
  if (focus == Focus::slider) return stage_.slider.has_value();
  if (focus == Focus::view) return !camera_.is_flat;
  if (focus == Focus::origin) return handle_of(Grip::origin) || handle_of(Grip::point);
  if (focus == Focus::tip) return handle_of(Grip::tip).has_value();
  return true;
}

void Player::move_focus(bool is_backward) {
  auto place = static_cast<std::size_t>(focus_);
  do {
    place = (place + (is_backward ? all_focuses.size() - 1 : 1)) % all_focuses.size();
  } while (!can_focus(all_focuses[place]));
  focus_ = all_focuses[place];
}

bool Player::press_arrow(const std::string& key) {
  const double right = key == "Right" ? 1 : key == "Left" ? -1 : 0;
  const double up = key == "Up" ? 1 : key == "Down" ? -1 : 0;
  if (right == 0 && up == 0) return false;
  switch (focus_) {
    case Focus::steps:
      if (right > 0) go_to(step_ + 1);
      if (right < 0 && step_ > 0) go_to(step_ - 1);
      move_slider(up * slider_part);
      break;
    case Focus::slider:
      move_slider((right + up) * slider_part);
      break;
    case Focus::view:
      camera_ = turned(camera_, right * turn, up * turn);
      break;
    case Focus::origin:
    case Focus::tip: {
      auto handle = handle_of(focus_ == Focus::tip ? Grip::tip : Grip::origin);
      if (!handle) handle = handle_of(Grip::point);
      if (handle) move_handle(stage_.one, *handle, right * handle_pixels, -up * handle_pixels);
      if (!can_focus(focus_)) focus_ = Focus::steps;
      break;
    }
  }
  return true;
}

Request Player::press_key(const std::string& key, bool is_shifted) {
  if (drag_ == Drag::handle) release();  // what is held may be gone after the key
  if (is_one_of(key, {"q", "Q"})) return Request::quit;
  if (key == "c") return Request::print_case;
  if (key == "s") return Request::save_picture;
  if (is_one_of(key, {"h", "H", "F1", "question", "slash"})) {
    is_help_shown_ = !is_help_shown_;
    return Request::none;
  }
  if (key == "Escape") {
    if (!is_help_shown_) focus_ = Focus::steps;
    is_help_shown_ = false;
    return Request::none;
  }
  const std::size_t last = stage_.steps.size() - 1;
  const int number = step_of(key);
  if (press_arrow(key)) return Request::none;
  if (is_one_of(key, {"Tab", "ISO_Left_Tab"})) move_focus(is_shifted || key == "ISO_Left_Tab");
  if (is_one_of(key, {"Next", "space"})) go_to(step_ + 1);
  if (is_one_of(key, {"Prior", "BackSpace"})) go_to(step_ > 0 ? step_ - 1 : 0);
  if (key == "Home") go_to(0);
  if (key == "End") go_to(last);
  if (number >= 0 && static_cast<std::size_t>(number) <= last) go_to(static_cast<std::size_t>(number));
  const double more = is_one_of(key, {"plus", "equal", "KP_Add"})              ? 1
                      : is_one_of(key, {"minus", "underscore", "KP_Subtract"}) ? -1
                                                                               : 0;
  if (more != 0 && focus_ == Focus::view) turn_wheel(static_cast<int>(more));
  if (more != 0 && focus_ != Focus::view) move_slider(more * slider_part);
  if (is_one_of(key, {"period", "bracketright"})) set_t(neighbour_of(t_, 1, stage_.precision));
  if (is_one_of(key, {"comma", "bracketleft"})) set_t(neighbour_of(t_, -1, stage_.precision));
  if (is_one_of(key, {"r", "R"})) reset();
  if (key == "n" && play_ + 1 < plays_.size()) show_play(play_ + 1);
  if (key == "p" && play_ > 0) show_play(play_ - 1);
  return Request::none;
}

}  // namespace rayproof::viz
