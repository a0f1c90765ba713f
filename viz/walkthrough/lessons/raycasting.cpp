#include <fmt/format.h>

#include <array>
#include <rayproof/sphere/centred.hpp>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/lessons/camera_image.hpp"
#include "viz/walkthrough/setting.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

using namespace camera_image;

struct LoopSphere {
  glm::dvec3 center;
  double radius;
  const char* name;
};
constexpr std::array<LoopSphere, 2> balls{{{{0, 0, 0.2}, 0.75, "first"}, {{1.2, -0.4, 0.6}, 0.4, "second"}}};

Ray<double> ray_of_pixel(int i, int j) {
  return camera::PixelCentre::ray(eye, camera::axes(eye), ImageSize<double>{width, height},
                                  static_cast<double>(i), static_cast<double>(j));
}

/// The nearer of two hits of a pixel's ray: 0 or 1, or -1 for none; by the library's own routine in double.
int nearest_ball(int i, int j) {
  const Ray<double> ray = ray_of_pixel(i, j);
  int best_ball = -1;
  double best = infinity<double>;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const double t =
        rayproof::nearest(ray, sphere::Centred::roots(ray, Sphere<double>{balls[k].center, balls[k].radius}));
    if (t < best) {
      best = t;
      best_ball = static_cast<int>(k);
    }
  }
  return best_ball;
}

Case with_ball(const Case& one, const LoopSphere& ball) {
  Case other = one;
  std::get<RayQuestion>(other.question).shape = Sphere<double>{ball.center, ball.radius};
  return other;
}

/// The object's own t₀, as its run names it.
StageValue first_root(const CaseReport& report) {
  const WalkValue& value = value_named("t₀", *report.walk);
  return {"t₀", value.formula, with_numbers(value.formula, report.one.precision), {value}};
}

StageStep loop_step(const char* title, std::string caption, const StageView& view, Items items) {
  return {.title = title, .caption = std::move(caption), .items = std::move(items), .view = view};
}

/// The loop's inside: the ray meets one object after the other, and the nearest stays.
void meet_balls(Stage& stage, const Case& one, const ReportCase& report_on, const StageView& view) {
  static constexpr std::array<const char*, 2> titles{"Meet the first object", "Meet the second object"};
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  std::vector<double> roots;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const StageValue root = first_root(report_on(with_ball(one, balls.at(k)), "sphere/centred"));
    roots.push_back(root.components.at(0).value);
    StageStep step = loop_step(titles.at(k),
                               fmt::format("The nearest hit of the {} sphere: {}", balls.at(k).name,
                                           equation_of(root, one.precision)),
                               view,
                               {point(Role::claimed, ray.origin + roots.back() * ray.direction,
                                      fmt::format("t = {}", rough(roots.back(), 5)))});
    step.values = {root};
    stage.steps.push_back(std::move(step));
  }
  const std::size_t best = roots[1] < roots[0] ? 1 : 0;
  stage.steps.push_back(loop_step(
      "Keep the nearest hit",
      fmt::format("min({}, {}) = {}: the {} object is what is seen.", shown(roots[0], one.precision),
                  shown(roots[1], one.precision), shown(roots[best], one.precision), balls.at(best).name),
      view, {segment(Role::nearest, ray.origin, ray.origin + roots[best] * ray.direction, "what is seen")}));
}

/// A pixel whose ray meets nothing.
StageStep missing_step(const StageView& view) {
  constexpr int i = 1, j = 4;
  const Ray<double> ray = ray_of_pixel(i, j);
  const bool is_missed = nearest_ball(i, j) < 0;
  StageStep step = loop_step(
      "Go on with the next pixels",
      fmt::format("The ray through pixel ({}, {}) meets {}. The loop runs over all {} × {} pixels.", i, j,
                  is_missed ? "no object: it keeps the background's colour" : "an object", width, height),
      view,
      {arrow(Role::ray, ray.origin, ray.origin + 3.6 * ray.direction, "another ray"),
       pixel(Role::nearest, i, j)});
  step.begins_anew = true;
  return step;
}

}  // namespace

Stage loop_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(with_ball(one, balls[1]), "sphere/centred");
  Setting setting = setting_of(report);
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  setting.scene = grid();
  for (const LoopSphere& each : balls) setting.scene.push_back(ball(each.center, each.radius));
  setting.scene.push_back(point(Role::ray, eye.eye, "eye"));
  setting.camera = behind_the_eye(20);
  const StageView view = view_of(extent_of(setting.scene, setting.camera), setting.camera);
  setting.near = setting.wide = view;
  Stage stage = stage_of(report);
  stage.scene = setting.scene;
  stage.camera = setting.camera;
  stage.slider->from = 0;
  stage.slider->readouts.clear();
  stage.steps = {loop_step("Look at the eye, the image and the objects",
                           "8 × 6 pixels, and two spheres behind them.", view, {}),
                 loop_step("For each pixel shoot a ray",
                           fmt::format("Through the centre of pixel ({}, {}): d = {}", pixel_i, pixel_j,
                                       shown(ray.direction, one.precision)),
                           view,
                           {arrow(Role::ray, ray.origin, ray.origin + 4.6 * ray.direction, "the ray"),
                            pixel(Role::nearest, pixel_i, pixel_j)})};
  meet_balls(stage, one, report_on, view);
  stage.steps.push_back(missing_step(view));
  Items image;
  int hits = 0;
  for (int i = 0; i < width; ++i) {
    for (int j = 0; j < height; ++j) {
      const int ball = nearest_ball(i, j);
      if (ball < 0) continue;
      ++hits;
      const StageItem& filled = image.emplace_back(pixel(ball == 0 ? Role::edge : Role::nearest, i, j));
      if (ball == 1) image.push_back(segment(filled.role, filled.points[0], filled.points[2]));
    }
  }
  stage.steps.push_back(
      loop_step("Colour every pixel by its nearest object",
                fmt::format("{} of {} pixels see an object: plain the first, with a diagonal the second.",
                            hits, width * height),
                view, image));
  stage.steps.push_back(difference_step(report, setting));
  return stage;
}

}  // namespace rayproof::viz
