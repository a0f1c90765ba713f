#include "viz/player/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "case/json/number_text.hpp"
#include "case/reader.hpp"
#include "case/writer.hpp"
#include "viz/scene/film.hpp"
#include "viz/scene/space.hpp"

namespace rayproof::viz {
namespace {

/// Whether the stage's slider runs along the ray of its case, so that the scene shows that ray.
bool shows_ray(const std::optional<StageSlider>& slider, const Ray<double>& ray) {
  return slider && slider->shows_point && slider->origin == ray.origin && slider->direction == ray.direction;
}

/// The t at which the ray leaves the ball of the view, or where its arrow ends before; nothing where it does
/// not come into it.
std::optional<double> last_t_in(const StageView& view, const Ray<double>& ray, const StageSlider& slider) {
  const glm::dvec3 to_centre = view.centre - ray.origin;
  const double square = glm::dot(ray.direction, ray.direction);
  const double middle = glm::dot(to_centre, ray.direction) / square;
  const glm::dvec3 off = to_centre - middle * ray.direction;
  const double room = view.radius * view.radius - glm::dot(off, off);
  if (!(room > 0)) return std::nullopt;
  const double t = std::min(middle + 0.95 * std::sqrt(room / square), slider.to);
  return t > std::max(ray.t_min, 0.0) ? std::optional(t) : std::nullopt;
}

Ray<double>& ray_of(Case& one) { return std::get<RayQuestion>(one.question).ray; }

void add_ray_handles(std::vector<Handle>& handles, const Ray<double>& ray, const StageSlider& slider,
                     const StageView& view) {
  handles.push_back({"origin", ray.origin, [](Case& next, const glm::dvec3& to, const Rounding& round) {
                       ray_of(next).origin = round(ray_of(next).origin, to);
                     }});
  const auto t = last_t_in(view, ray, slider);
  if (!t) return;
  const auto turn = [t = *t](Case& next, const glm::dvec3& to, const Rounding& round) {
    Ray<double>& moved = ray_of(next);
    moved.direction = round.magnified(t)(moved.direction, (to - moved.origin) / t);
  };
  handles.push_back({"tip", ray.origin + *t * ray.direction, turn});
}

}  // namespace

Player::Player(std::vector<Play> plays) : plays_(std::move(plays)) { show_play(0); }

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

double Rounding::operator()(double old, double next) const {
  if (!(std::abs(next - old) >= resolution_ / 2)) return old;
  const double digits = -std::floor(std::log10(resolution_));
  const bool has_decimals = digits >= 0 && digits < 300;
  if (!has_decimals) return round_to(precision_, std::isfinite(next) ? std::nearbyint(next) : next);
  return round_to(precision_,
                  parse_number(fmt::format("{:.{}f}", next, static_cast<int>(digits))).value_or(next));
}

glm::dvec3 Rounding::operator()(const glm::dvec3& old, const glm::dvec3& next) const {
  return {(*this)(old.x, next.x), (*this)(old.y, next.y), (*this)(old.z, next.z)};
}

std::vector<Handle> handles_of(const Stage& stage, std::size_t step) {
  const StageView& view = stage.steps.at(step).view;
  std::vector<Handle> handles;
  if (stage.steps[step].is_apart) return handles;
  if (const auto* asked = std::get_if<RayQuestion>(&stage.one.question)) {
    if (!shows_ray(stage.slider, asked->ray)) return handles;
    add_ray_handles(handles, asked->ray, *stage.slider, view);
  }
  for (Handle& handle : shape_handles(stage.one, view.radius, stage.camera.right)) {
    const auto is_there = [&](const Handle& other) {
      return glm::length(other.at - handle.at) < 0.02 * view.radius;
    };
    if (std::ranges::none_of(handles, is_there)) handles.push_back(std::move(handle));
  }
  std::erase_if(handles, [&](const Handle& handle) {
    const glm::dvec3 off = (handle.at - view.centre) / (1.1 * view.radius);
    return !(std::abs(glm::dot(off, stage.camera.right)) <= view_aspect &&
             std::abs(glm::dot(off, stage.camera.up)) <= 1 && glm::length(off) <= reach);
  });
  return handles;
}

Case moved(const Case& one, const Handle& handle, const glm::dvec3& to, double resolution) {
  Case next = one;
  handle.move(next, to, Rounding(resolution, one.precision));
  return read_case(write_case(next));
}

}  // namespace rayproof::viz
