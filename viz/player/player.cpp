#include "viz/player/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/json/number_text.hpp"
#include "viz/flat/orbit.hpp"

namespace rayproof::viz {
namespace {

/// How near a handle the button must go down to take hold of it.
constexpr double grip_reach = 13;
constexpr double radians_per_pixel = 0.01;

}  // namespace

Player::Player(std::vector<Play> plays) : plays_(std::move(plays)) { show_play(0); }

void Player::show_play(std::size_t play) {
  play_ = play;
  step_ = 0;
  reset();
}

void Player::reset() {
  stage_ = plays_[play_].stage;
  step_ = std::min(step_, stage_.steps.size() - 1);
  camera_ = stage_.camera;
  zoom_ = 1;
  focus_ = Focus::steps;
  complaint_.clear();
  drag_ = Drag::none;
  held_view_.reset();
  if (stage_.slider) set_t(stage_.slider->start);
  follows_hit_ = true;
}

void Player::go_to(std::size_t step) {
  step_ = std::min(step, stage_.steps.size() - 1);
  if (!can_focus(focus_)) focus_ = Focus::steps;
}

void Player::set_t(double t) {
  if (!stage_.slider) return;
  t_ = round_to(stage_.precision, std::clamp(t, stage_.slider->from, stage_.slider->to));
  follows_hit_ = false;
}

void Player::move_slider(double part) {
  if (stage_.slider) set_t(t_ + part * (stage_.slider->to - stage_.slider->from));
}

void Player::zoom_by(double factor) { zoom_ = std::clamp(zoom_ * factor, 0.25, 8.0); }

void Player::turn_wheel(int notches) { zoom_by(std::pow(1.25, notches)); }

StageView Player::view() const {
  StageView view = held_view_ ? *held_view_ : stage_.steps[step_].view;
  if (!held_view_) view.radius /= zoom_;
  return view;
}

ScreenProjection Player::projection() const { return {camera_, view(), slide_scene}; }

std::vector<Handle> Player::handles() const {
  if (stage_.steps[step_].is_apart) return {};
  return handles_of(stage_, projection());
}

std::optional<Handle> Player::handle_of(Grip grip) const {
  for (const Handle& handle : handles()) {
    if (handle.grip == grip) return handle;
  }
  return std::nullopt;
}

std::vector<Button> Player::buttons() const {
  return buttons_of({step_, stage_.steps.size(), play_, plays_.size(), is_help_shown_});
}

Request Player::press(const Point& at) {
  for (const Button& button : buttons()) {
    if (button.box.holds(at)) return button.is_enabled ? press_key(button.key) : Request::none;
  }
  if (stage_.slider && slider_track.holds(at)) {
    drag_ = Drag::slider;
    set_t(t_on_track(*stage_.slider, at.x));
    return Request::none;
  }
  if (is_help_shown_) {
    is_help_shown_ = false;
    return Request::none;
  }
  if (!slide_scene.holds(at)) return Request::none;
  held_at_ = at;
  drag_ = Drag::orbit;
  const ScreenProjection seen = projection();
  double nearest = grip_reach;
  for (const Handle& handle : handles()) {
    const Point p = seen.to_pixels(handle.at);
    const double distance = std::hypot(p.x - at.x, p.y - at.y);
    if (distance > nearest) continue;
    nearest = distance;
    drag_ = Drag::handle;
    held_ = handle;
    held_case_ = stage_.one;
    held_view_ = seen.view;
  }
  return Request::none;
}

void Player::drag_to(const Point& at) {
  const double right = at.x - held_at_.x;
  const double down = at.y - held_at_.y;
  if (drag_ == Drag::slider) set_t(t_on_track(*stage_.slider, at.x));
  if (drag_ == Drag::handle) move_handle(held_case_, held_, right, down);
  if (drag_ != Drag::orbit) return;
  camera_ = turned(camera_, right * radians_per_pixel, -down * radians_per_pixel);
  held_at_ = at;
}

void Player::release() {
  drag_ = Drag::none;
  held_view_.reset();
}

void Player::move_handle(const Case& one, const Handle& handle, double right, double down) {
  const ScreenProjection seen = projection();
  const double resolution = 1 / seen.pixels_per_length();
  const glm::dvec3 to = handle.at + resolution * (right * camera_.right - down * camera_.up);
  try {
    take(moved(one, handle, to, resolution));
  } catch (const std::exception& why) {
    complaint_ = fmt::format("{}; the case before stays", why.what());
  }
}

void Player::take(const Case& one) {
  Stage next = plays_[play_].again(one);
  if (next.steps.empty()) return;
  stage_ = std::move(next);
  complaint_.clear();
  step_ = std::min(step_, stage_.steps.size() - 1);
  if (!stage_.slider) return;
  const bool follows_hit = follows_hit_;
  set_t(follows_hit ? stage_.slider->start : t_);
  follows_hit_ = follows_hit;
}

}  // namespace rayproof::viz
