#include "viz/drawing/topics/wireframe_scene.hpp"

#include <algorithm>
#include <cmath>

#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

std::optional<Shadow> first_hit(const Answer* exact, const Answer* claimed) {
  for (const Answer* answer : {exact, claimed}) {
    for (const double t : values_of(answer)) {
      if (std::isfinite(t)) return Shadow(t);
    }
  }
  return std::nullopt;
}

/// Across the ray and along the surface with the given normal: it is then seen as a line.
Place toward_for(const WireframeScene& scene, const Place& normal, const ViewCamera& main) {
  const Place across = cross(scene.along_ray, normal);
  const bool is_clear = length(across) > Shadow(1e-12);
  const Place toward = is_clear ? unit(across) : some_perpendicular(scene.along_ray);
  return dot(toward, main.toward) < 0 ? Place(Shadow(-1) * toward) : toward;
}

/// A look at the stretch of the ray between a hit and another t.
WireframeInset stretch_inset(const WireframeScene& scene, const ViewCamera& main, const PixelBox& frame,
                             const Shadow& hit_t, const Shadow& other_t, const std::string& label) {
  const Place hit = scene.at(hit_t);
  const Place normal = scene.figure.normal_at ? scene.figure.normal_at(hit) : scene.figure.normals.front();
  const Place middle = scene.at((hit_t + other_t) / 2);
  const ViewCamera camera = ViewCamera::from(middle, toward_for(scene, normal, main), scene.along_ray);
  const WorldPoint from = camera.see(hit);
  const WorldPoint to = camera.see(scene.at(other_t));
  const Shadow size = abs(to.x - from.x);
  WireframeInset inset{camera, View::around(frame, {0, 0}, size * Shadow(1.6), size * Shadow(0.01)), middle};
  inset.measured = {from, to};
  inset.label = label;
  const Place slope = unit(cross(normal, camera.toward));
  const Shadow reach = inset.view.half_width() * 3;
  inset.surface = {hit - reach * slope, hit + reach * slope};
  return inset;
}

/// A look along the outline at the gap between it and the ray: there the outline is a point below the ray,
/// and what meets in it, faces or a round side, is seen in profile. Hits too near to be distinguished
/// otherwise are shown, too, if need be by stretching.
WireframeInset gap_inset(const WireframeScene& scene, const View& main, const PixelBox& frame,
                         const NearestPass& nearest) {
  const Place up = unit(nearest.on_ray - nearest.on_outline);
  const bool runs_along = length(cross(nearest.side, scene.along_ray)) < Shadow(1e-3);
  Place toward = runs_along ? cross(scene.along_ray, up) : nearest.side;
  if (dot(cross(toward, scene.along_ray), up) < 0) toward = Shadow(-1) * toward;
  const ViewCamera camera = ViewCamera::from(nearest.on_ray, toward, scene.along_ray);
  Shadow half_width = nearest.gap;
  for (const NamedMark& hit : scene.marks(camera)) {
    if (abs(hit.at.x) * main.scale_x < 3 * visible_gap)
      half_width = std::max<Shadow>(half_width, abs(hit.at.x) * 1.3);
  }
  const Shadow half_height = nearest.gap * Shadow(1.8);
  View view = View::around(frame, {0, -nearest.gap / 2}, half_width, half_height);
  if (half_width > 4 * half_height) view.scale_y = frame.height / 2 / half_height;
  WireframeInset inset{camera, view, nearest.on_ray};
  inset.measured = {{0, 0}, {0, -nearest.gap}};
  inset.label = rough(nearest.gap, 2) + " between";
  return inset;
}

}  // namespace

std::vector<NamedMark> WireframeScene::marks(const ViewCamera& camera) const {
  return marks_of("t", exact, claimed, [&](double t) { return WorldPoint{camera.see(at(t)).x, 0}; });
}

RayLine WireframeScene::line(const ViewCamera& camera) const {
  RayLine line;
  if (isfinite(sight.ray.t_min)) line.start = camera.see(at(sight.ray.t_min)).x;
  if (isfinite(sight.ray.t_max)) line.end = camera.see(at(sight.ray.t_max)).x;
  return line;
}

ViewCamera WireframeScene::main_camera() const {
  Place middle{0, 0, 0};
  for (const Place& p : figure.extent) middle = middle + p;
  middle = Shadow(1) / static_cast<unsigned>(figure.extent.size()) * middle;
  const Shadow t = dot(middle - sight.ray.origin, along_ray) / direction_size;
  return ViewCamera::chosen(at(t), along_ray, figure.normals);
}

WireframeScene scene_of(Figure (*maker)(const Sight&), const Case& one, const Answer* exact,
                        const Answer* claimed) {
  const auto& question = std::get<RayQuestion>(one.question);
  const Sight sight{question, World(question), convert<Shadow>(question.ray), first_hit(exact, claimed)};
  const Place& d = sight.ray.direction;
  return {sight, maker(sight), unit(d), length(d), exact, claimed};
}

std::optional<NearestPass> nearest_of(const WireframeScene& scene) {
  const Ray<Shadow>& ray = scene.sight.ray;
  const auto across = [&](const Place& v) { return v - dot(v, scene.along_ray) * scene.along_ray; };
  std::optional<NearestPass> nearest;
  Shadow square_gap = 0;
  for (const std::vector<Place>& border : scene.figure.borders) {
    for (std::size_t i = 0; i + 1 < border.size(); ++i) {
      const Place side = border[i + 1] - border[i];
      const Place from_ray = across(border[i] - ray.origin);
      const Place side_across = across(side);
      const Shadow square = dot(side_across, side_across);
      const Shadow part = square == 0 ? Shadow(0) : Shadow(-dot(from_ray, side_across) / square);
      const Place on_outline = border[i] + std::clamp<Shadow>(part, 0, 1) * side;
      const Shadow t = dot(on_outline - ray.origin, scene.along_ray) / scene.direction_size;
      if (!in_interval(ray, t)) continue;
      const Place on_ray = scene.at(t);
      const Place between = on_outline - on_ray;
      const Shadow square_between = dot(between, between);
      if (nearest && square_between >= square_gap) continue;
      square_gap = square_between;
      nearest = {on_ray, on_outline, side, 0};
    }
  }
  if (nearest) {
    nearest->side = unit(nearest->side);
    nearest->gap = sqrt(square_gap);
  }
  return nearest;
}

std::optional<WireframeInset> inset_of(const WireframeScene& scene, const ViewCamera& camera,
                                       const View& main, const PixelBox& frame) {
  const std::optional<NearestPass> nearest = nearest_of(scene);
  const Shadow pixel = 1 / main.scale_x;
  // A gap of 2^-200 of the scene is the rounding of the picture's own numbers: the ray meets the outline.
  const bool has_gap = nearest && nearest->gap > ldexp(pixel, -200);
  const bool hides_gap = has_gap && nearest->gap < 8 * pixel;
  if (hides_gap && verdicts_differ(scene.exact, scene.claimed))
    return gap_inset(scene, main, frame, *nearest);
  const auto on_axis = [](double t) { return WorldPoint{t, 0}; };
  if (const auto worst = worst_pair(scene.exact, scene.claimed, on_axis)) {
    const auto& [truth, claim] = *worst;
    const Shadow error = abs(truth.x - claim.x) * scene.direction_size;
    if (error > visible_gap * pixel) return {};
    return stretch_inset(scene, camera, frame, truth.x, claim.x, "off by " + rough(error, 2));
  }
  if (hides_gap) return gap_inset(scene, main, frame, *nearest);
  if (!isfinite(scene.sight.ray.t_min) || !scene.sight.first_t) return {};
  const Shadow t_min = scene.sight.ray.t_min;
  const Shadow from_start = abs(*scene.sight.first_t - t_min) * scene.direction_size;
  if (from_start == 0 || from_start > visible_gap * pixel) return {};
  return stretch_inset(scene, camera, frame, *scene.sight.first_t, t_min,
                       rough(from_start, 2) + " from the start");
}

}  // namespace rayproof::viz
