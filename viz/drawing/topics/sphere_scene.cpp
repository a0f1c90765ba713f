#include "viz/drawing/topics/sphere_scene.hpp"

#include <algorithm>
#include <cmath>

#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// A sphere smaller than this, in pixels, is a speck.
constexpr double speck = 26;

Inset error_inset(const SphereScene& scene, const PixelBox& frame) {
  const auto& [truth, claim] = *scene.worst;
  const Shadow error = abs(truth.x - claim.x);
  const View view = View::around(frame, {(truth.x + claim.x) / 2, 0}, error * 1.6, error * 0.01);
  return {view, scene.worst, "off by " + rough(error, 2)};
}

/// Half of the stretch along the line in which the sphere's outline bends by about its gap from the line.
Shadow half_stretch(const SphereScene& scene) {
  const RayPlane& plane = scene.plane;
  const Shadow bend = sqrt(2 * plane.radius * abs(plane.gap()));
  Shadow half = std::max<Shadow>(plane.half_chord(), bend);
  const Shadow claimed = scene.farthest_claimed();
  if (claimed < 20 * half || half == 0) half = std::max<Shadow>(half, claimed);
  return half * 1.5;
}

Inset gap_inset(const SphereScene& scene, const PixelBox& frame) {
  const RayPlane& plane = scene.plane;
  const Shadow gap = plane.gap();
  Shadow half_width = half_stretch(scene);
  Shadow half_height = abs(gap) * 2;
  if (half_width == 0) half_width = half_height;
  if (half_height == 0) half_height = half_width * half_width / plane.radius;
  View view = View::around(frame, {0, -gap / 2}, half_width, half_height);
  // A sliver is stretched across, so that the outline's bend and its gap are both seen.
  if (half_width > 4 * half_height) view.scale_y = frame.height / 2 / half_height;
  if (gap == 0) return {view, {}, ""};
  return {view, {{{0, 0}, {0, -gap}}}, rough(abs(gap), 2) + (gap > 0 ? " outside" : " inside")};
}

}  // namespace

Shadow SphereScene::farthest_claimed() const {
  Shadow farthest = 0;
  for (const NamedMark& hit : hits) {
    if (hit.role == Role::claimed) farthest = std::max<Shadow>(farthest, abs(hit.at.x));
  }
  return farthest;
}

SphereScene scene_of(const Case& one, const Answer* exact, const Answer* claimed) {
  const auto& question = std::get<RayQuestion>(one.question);
  SphereScene scene{plane_of(question), question.ray, {}, viz::verdicts_differ(exact, claimed), {}};
  const auto place = [&](double t) { return scene.plane.at(t); };
  scene.hits = marks_of("t", exact, claimed, place);
  if (!scene.verdicts_differ) scene.worst = worst_pair(exact, claimed, place);
  return scene;
}

MainView main_view(const SphereScene& scene, const PixelBox& frame) {
  const RayPlane& plane = scene.plane;
  Shadow unit = std::max<Shadow>(plane.radius, plane.height);
  if (unit == 0 && scene.has_start()) unit = abs(scene.start().x) / 4;
  if (unit == 0) unit = plane.direction_length;
  const auto looking_at = [&](Shadow left, Shadow right) {
    const Shadow top = std::max<Shadow>(0, -plane.gap());
    const Shadow bottom = -plane.height - plane.radius;
    return View::around(frame, {(left + right) / 2, (top + bottom) / 2}, (right - left) * 0.58 + unit * 0.08,
                        (top - bottom) * 0.68 + unit * 0.02);
  };
  Shadow left = -unit;
  Shadow right = unit;
  const View alone = looking_at(left, right);
  for (const NamedMark& hit : scene.hits) {
    if (abs(hit.at.x) > 4 * unit) continue;
    left = std::min<Shadow>(left, hit.at.x);
    right = std::max<Shadow>(right, hit.at.x);
  }
  if (!scene.has_start()) return {looking_at(left, right), false};
  const Shadow start = scene.start().x;
  const View whole = looking_at(std::min<Shadow>(left, start), std::max<Shadow>(right, start));
  const bool is_speck =
      plane.radius > 0 && plane.radius * whole.scale_x < speck && whole.scale_x < alone.scale_x / 2;
  return is_speck ? MainView{looking_at(left, right), true} : MainView{whole, false};
}

std::optional<Inset> inset_of(const SphereScene& scene, const View& main, const PixelBox& frame) {
  const RayPlane& plane = scene.plane;
  const bool hides_gap = abs(plane.gap()) * main.scale_y < visible_gap / 2 && plane.radius > 0;
  if (scene.verdicts_differ && hides_gap && half_stretch(scene) > 0) return gap_inset(scene, frame);
  if (scene.worst) {
    const auto& [truth, claim] = *scene.worst;
    if (abs(truth.x - claim.x) * main.scale_x < visible_gap) return error_inset(scene, frame);
    return {};
  }
  if (hides_gap && plane.gap() != 0) return gap_inset(scene, frame);
  for (const NamedMark& hit : scene.hits) {
    if (!scene.has_start()) break;
    const Shadow from_start = abs(hit.at.x - scene.start().x);
    if (from_start == 0 || from_start * main.scale_x > visible_gap) continue;
    const WorldPoint middle{(hit.at.x + scene.start().x) / 2, 0};
    return Inset{View::around(frame, middle, from_start * 1.6, from_start * 0.01),
                 {{scene.start(), hit.at}},
                 rough(from_start, 2) + " from the start"};
  }
  return {};
}

}  // namespace rayproof::viz
