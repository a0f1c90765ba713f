#include "viz/player/player.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/json/number_text.hpp"
#include "viz/scene/film.hpp"

namespace rayproof::viz {

Player::Player(std::vector<Play> plays) : plays_(std::move(plays)) { show_play(0); }

void Player::show_play(std::size_t play) {
  play_ = play;
  step_ = 0;
  reset();
}

void Player::reset() {
  stage_ = plays_[play_].stage;
  step_ = std::min(step_, stage_.steps.size() - 1);
  put_focus(Focus::steps);
  complaint_.clear();
  held_.reset();
  if (stage_.slider) set_t(stage_.slider->start);
  follows_hit_ = true;
}

void Player::go_to(std::size_t step) {
  step_ = std::min(step, stage_.steps.size() - 1);
  release();
  const auto has_focus = [this](const Handle& handle) { return handle.name == focused_; };
  const std::vector<Handle> all = handles();
  if (focus_ == Focus::handle && std::ranges::none_of(all, has_focus)) put_focus(Focus::steps);
}

void Player::set_t(double t) {
  if (!stage_.slider) return;
  t_ = round_to(stage_.precision, std::clamp(t, stage_.slider->from, stage_.slider->to));
  follows_hit_ = false;
}

void Player::move_slider(double part) {
  if (stage_.slider) set_t(t_ + part * (stage_.slider->to - stage_.slider->from));
}

void Player::put_focus(Focus focus, const std::string& handle) {
  focus_ = focus;
  focused_ = handle;
}

void Player::grasp(const std::string& handle) {
  for (Handle& one : handles()) {
    if (one.name != handle) continue;
    held_ = Grasp{std::move(one), stage_.one, stage_.steps[step_].view};
    put_focus(Focus::handle, handle);
  }
}

void Player::drag_to(const glm::dvec3& to, double resolution) {
  if (!held_) return;
  try {
    take(moved(held_->one, held_->handle, to, resolution));
  } catch (const std::exception& why) {
    complaint_ = fmt::format("{}; the case before stays", why.what());
  }
}

void Player::release() { held_.reset(); }

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

Stage Player::shown() const {
  Stage stage = stage_;
  if (held_) stage.steps[step_].view = held_->view;
  add_runner(stage, step_, t_);
  return stage;
}

}  // namespace rayproof::viz
