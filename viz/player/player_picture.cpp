/// \file
/// How the player looks: the slide, what moves in it, and the controls below.

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "viz/player/player.hpp"
#include "viz/player/player_help.hpp"
#include "viz/scene/label_places.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/live_values.hpp"

namespace rayproof::viz {
namespace {

constexpr double rounded_column = 214;
constexpr double exact_column = 520;

void outline(Picture& picture, Role role, const PixelBox& box, double width,
             Pattern pattern = Pattern::solid) {
  picture.elements.emplace_back(PixelLine{role,
                                          {{box.left, box.top},
                                           {box.right(), box.top},
                                           {box.right(), box.bottom()},
                                           {box.left, box.bottom()},
                                           {box.left, box.top}},
                                          width,
                                          pattern});
}

PixelBox around(const Point& p, double radius) {
  return {p.x - radius, p.y - radius, 2 * radius, 2 * radius};
}

void draw_button(Picture& picture, const Button& button) {
  outline(picture, button.is_current ? Role::text : Role::frame, button.box, button.is_current ? 2.5 : 1.2);
  const double size = button.box.width < 24 ? 11 : 14;
  add_text(picture, button.is_enabled ? Role::text : Role::frame,
           {button.box.centre().x, button.box.centre().y + size * 0.36}, button.text, size, button.is_current,
           Anchor::middle);
}

/// The whole range with its ends, and a bar where t stands.
void draw_slider(Picture& picture, const StageSlider& slider, double t, Precision precision,
                 bool is_focused) {
  const double y = slider_track.centre().y;
  add_text(picture, Role::text, {slide_margin, y + 5},
           fmt::format("{} = {}", slider.symbol, shown(t, precision)), 16, true);
  picture.elements.emplace_back(
      PixelLine{Role::frame, {{slider_track.left, y}, {slider_track.right(), y}}, 3});
  const double x = x_on_track(slider, t);
  picture.elements.emplace_back(PixelLine{Role::text, {{x, y - 11}, {x, y + 11}}, 7});
  if (is_focused) outline(picture, Role::claimed, {x - 8, y - 15, 16, 30}, 2);
  add_text(picture, Role::muted, {slider_track.left, y + 24}, rough(slider.from), 11);
  add_text(picture, Role::muted, {slider_track.right(), y + 24}, rough(slider.to), 11, false, Anchor::end);
}

void draw_live_values(Picture& picture, const StageSlider& slider, double t, Precision precision) {
  const bool is_float = precision == Precision::float32;
  double y = controls_top + 106;
  add_text(picture, Role::muted, {rounded_column, y}, is_float ? "float" : "double", 12);
  if (is_float) add_text(picture, Role::muted, {exact_column, y}, "exact", 12);
  for (const LiveValue& value : live_values(slider, t, precision)) {
    y += 18;
    add_text(picture, Role::text, {slide_margin, y}, value.label, 13, true);
    add_text(picture, Role::claimed, {rounded_column, y}, value.rounded, 13);
    add_text(picture, Role::exact, {exact_column, y}, value.exact, 13);
  }
}

/// Lines that were hidden from where the scene was seen first may be so no more.
void show_hidden_lines(Stage& stage) {
  for (StageItem& item : stage.scene) {
    if (item.pattern == Pattern::dashed) item.pattern = Pattern::solid;
  }
}

const char* name_of(Focus focus) {
  switch (focus) {
    case Focus::steps:
      return "the steps";
    case Focus::slider:
      return "the slider";
    case Focus::view:
      return "the view";
    case Focus::origin:
      return "the origin";
    case Focus::tip:
      break;
  }
  return "the arrow's tip";
}

}  // namespace

void Player::draw_runner(Picture& picture) const {
  if (!stage_.slider || stage_.steps[step_].is_apart) return;
  const Point p = projection().to_pixels(stage_.slider->origin + t_ * stage_.slider->direction);
  if (!slide_scene.holds(p)) return;
  const Point left{p.x - 7, p.y + 16};
  const Point right{p.x + 7, p.y + 16};
  picture.elements.emplace_back(Area{Role::ray, {p, right, left}});
  picture.elements.emplace_back(PixelLine{Role::ray, {{p.x, p.y + 2}, right, left, {p.x, p.y + 2}}, 2.2});
}

void Player::draw_handles(Picture& picture) const {
  const ScreenProjection seen = projection();
  for (const Handle& handle : handles()) {
    const bool is_focused = focus_ == (handle.grip == Grip::tip ? Focus::tip : Focus::origin);
    const bool is_held = drag_ == Drag::handle && held_.grip == handle.grip;
    const Role role = is_focused || is_held ? Role::claimed : Role::muted;
    // What is held stays at the pointer, though the arrow is drawn to the frame's border.
    const glm::dvec3 at = is_held ? place_of(held_, stage_.one) : handle.at;
    outline(picture, role, around(seen.to_pixels(at), 9), is_focused || is_held ? 2.5 : 1.5);
  }
}

void Player::draw_controls(Picture& picture) const {
  picture.elements.emplace_back(
      PixelLine{Role::frame, {{0, controls_top}, {player_width, controls_top}}, 1.2});
  for (const Button& button : buttons()) draw_button(picture, button);
  if (stage_.slider) {
    draw_slider(picture, *stage_.slider, t_, stage_.precision, focus_ == Focus::slider);
    draw_live_values(picture, *stage_.slider, t_, stage_.precision);
  }
  const Point bottom{slide_margin, player_height - 12};
  if (!complaint_.empty()) {
    add_text(picture, Role::claimed, bottom, wrapped(complaint_, player_width - 2 * slide_margin, 13).front(),
             13, true);
    return;
  }
  std::string hint = fmt::format("The arrow keys move {} (Tab: the next).", name_of(focus_));
  if (!handles().empty()) hint += " Drag a square to move it";
  if (!camera_.is_flat) hint += handles().empty() ? " Drag to look around." : ", elsewhere to look around.";
  add_text(picture, Role::muted, bottom, hint, 12);
}

Picture Player::picture() const {
  Stage seen = stage_;
  seen.camera = camera_;
  seen.steps[step_].view = view();
  const bool is_turned = camera_.toward != stage_.camera.toward || camera_.up != stage_.camera.up;
  if (is_turned) show_hidden_lines(seen);
  Picture picture = is_help_shown_ ? help_picture(stage_) : slide_picture(seen, step_);
  picture.width = player_width;
  picture.height = player_height;
  if (!is_help_shown_) {
    draw_runner(picture);
    draw_handles(picture);
    if (focus_ == Focus::view) outline(picture, Role::claimed, slide_scene, 2, Pattern::dotted);
  }
  draw_controls(picture);
  return picture;
}

}  // namespace rayproof::viz
