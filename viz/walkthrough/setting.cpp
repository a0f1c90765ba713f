#include "viz/walkthrough/setting.hpp"

#include <algorithm>
#include <cmath>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"
#include "viz/shapes/figure.hpp"
#include "viz/shapes/topics.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"

namespace rayproof::viz {
namespace {

/// The lines on the figure, then its surface over them.
Items items_of(const Figure& figure) {
  Items items;
  for (const auto& line : figure.grid) items.push_back(polyline(Role::frame, rounded(line)));
  std::vector<glm::dvec3> points = rounded(figure.points);
  if (!figure.ellipsoid.empty()) {
    items.push_back({Role::surface, Form::ellipsoid, rounded(figure.ellipsoid)});
  } else if (figure.faces.size() == 1) {
    items.push_back(polygon(Role::surface, points));
    points.push_back(points.front());
    items.push_back(polyline(Role::surface, points));
  } else {
    items.push_back({Role::surface, Form::solid, points, {}, Pattern::solid, figure.faces});
  }
  // A corner shows itself, a centre needs a dot.
  const Role label = figure.ellipsoid.empty() ? Role::surface : Role::edge;
  for (const auto& [name, at] : figure.labels) items.push_back(point(label, rounded(at), name));
  return items;
}

/// The stretch of t on which the ray's line is in the view, within the ray's interval where it reaches so
/// far.
std::pair<double, double> stretch_in(const StageView& view, const Ray<double>& ray) {
  const double speed = glm::length(ray.direction);
  const double middle = glm::dot(view.centre - ray.origin, ray.direction) / (speed * speed);
  const double half = 1.1 * view_aspect * view.radius / speed;  // a little beyond the view
  const double from = std::max(middle - half, ray.t_min);
  const double to = std::min(middle + half, ray.t_max);
  return from < to ? std::pair{from, to} : std::pair{middle - half, middle + half};
}

struct Views {
  StageView near, wide;
};

Views views_of(const RayScene& scene, const CaseReport& report, const StageCamera& camera) {
  std::vector<glm::dvec3> points = rounded(scene.figure.points);
  const StageView figure = view_of(points, camera);
  const auto add_if_near = [&](const glm::dvec3& p) {
    if (glm::length(p - figure.centre) <= 8 * figure.radius) points.push_back(p);
  };
  for (const Answer* answer : {&report.exact, report.claim()}) {
    for (const double t : values_of(answer)) {
      if (std::isfinite(t)) add_if_near(rounded(scene.at(t)));
    }
  }
  const bool starts = isfinite(scene.sight.ray.t_min);
  const glm::dvec3 start = rounded(starts ? scene.at(scene.sight.ray.t_min) : scene.sight.ray.origin);
  add_if_near(start);
  if (!scene.figure.ellipsoid.empty()) {
    const StageItem ellipsoid{Role::surface, Form::ellipsoid, rounded(scene.figure.ellipsoid)};
    for (const glm::dvec3& p : extent_of(ellipsoid, camera)) points.push_back(p);
  }
  const StageView near = view_of(points, camera);
  points.push_back(start);
  return {near, view_of(points, camera)};
}

/// What is 0 where the ray meets the shape, where that is a polynomial in t.
std::vector<StageReadout> readouts_of(const RayQuestion& question) {
  if (question.transform) return {};
  const Ray<double>& ray = question.ray;
  if (const auto* sphere = std::get_if<Sphere<double>>(&question.shape)) {
    const glm::dvec3 f = ray.origin - sphere->center;
    return {{"|p − C|² − r²",
             {glm::dot(f, f) - sphere->radius * sphere->radius, 2 * glm::dot(f, ray.direction),
              glm::dot(ray.direction, ray.direction)}}};
  }
  if (const auto* triangle = std::get_if<Triangle<double>>(&question.shape)) {
    const glm::dvec3 n = glm::cross(triangle->b - triangle->a, triangle->c - triangle->a);
    return {{"n·(p − a)", {glm::dot(n, ray.origin - triangle->a), glm::dot(n, ray.direction)}}};
  }
  return {};
}

StageSlider slider_of(const RayScene& scene, const StageView& near, const CaseReport& report) {
  const auto& question = std::get<RayQuestion>(report.one.question);
  const auto [from, to] = stretch_in(near, question.ray);
  StageSlider slider;
  slider.origin = question.ray.origin;
  slider.direction = question.ray.direction;
  slider.from = from;
  slider.to = to;
  const bool has_start = scene.sight.first_t.has_value();
  slider.start =
      std::clamp(has_start ? static_cast<double>(*scene.sight.first_t) : (from + to) / 2, from, to);
  slider.readouts = readouts_of(question);
  return slider;
}

/// How far off the ray's start is, where the ray comes into the view, clear of the shape.
StageItem far_start(const StageSlider& slider, const StageView& view, const StageCamera& camera) {
  const double speed = glm::length(slider.direction);
  const double t = glm::dot(view.centre - slider.origin, slider.direction) / (speed * speed);
  const double seen = glm::length(glm::cross(slider.direction, camera.toward));  // of a unit of t
  const double back = 1.5 * view.radius / std::max(seen, 0.3 * speed);
  const glm::dvec3 at = slider.origin + (t > 0 ? t - back : t + back) * slider.direction;
  const double off = glm::length(view.centre - slider.origin);
  return point(Role::text, at, (t > 0 ? "← o, " : "o → ") + rough(off, 4) + " off");
}

void add_ray(Items& scene, const Ray<double>& ray, const StageSlider& slider, const char* origin = "o") {
  const bool starts = std::isfinite(ray.t_min);
  const glm::dvec3 start = ray.origin + (starts ? ray.t_min : slider.from) * ray.direction;
  if (ray.t_min == ray.t_max) {  // no more than a point of its line
    scene.push_back(segment(Role::ray, ray.origin + slider.from * ray.direction,
                            ray.origin + slider.to * ray.direction, {}, Pattern::dotted));
    scene.push_back(point(Role::ray, start, ray.t_min == 0 ? std::string(origin) + " = p(t)" : "p(t)"));
    if (ray.t_min != 0) scene.push_back(point(Role::ray, ray.origin, origin));
    return;
  }
  const glm::dvec3 end = ray.origin + std::max(slider.to, starts ? ray.t_min : slider.to) * ray.direction;
  if (starts && ray.t_min > 0) scene.push_back(segment(Role::ray, ray.origin, start, {}, Pattern::dotted));
  scene.push_back(arrow(Role::ray, start, end, "p(t)"));
  if (starts) scene.push_back(point(Role::ray, ray.origin, origin));
}

/// The shape and the ray as the kernel sees them, where the case has a transform.
StepSpace object_space_of(const CaseReport& report, const Setting& setting, const std::string& first_step) {
  Case one = report.one;
  auto& question = std::get<RayQuestion>(one.question);
  const Ray<Shadow> inside = World(question).ray_in_object_space(convert<Shadow>(question.ray));
  question.ray.origin = rounded(inside.origin);
  question.ray.direction = rounded(inside.direction);
  question.transform.reset();
  const RayScene scene = scene_of(one, &report.exact, report.claim());
  Items items = items_of(scene.figure);
  add_ray(items, question.ray, *setting.slider, "o′");
  return {first_step, "Drawn in the object's own space.",
          [items](const NumbersByName& /*n*/) { return items; }, [](const glm::dvec3& p) { return p; }};
}

std::vector<StepSpace> spaces_of(const CaseReport& report, const Setting& setting) {
  std::vector<StepSpace> spaces;
  if (!report.walk) return spaces;
  const std::vector<WalkStep>& steps = report.walk->steps;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    if (steps[i].title.starts_with("Take the ray into the "))
      spaces.push_back(object_space_of(report, setting, steps[i + 1].title));
  }
  if (auto space = padded_space(report, setting.camera)) spaces.push_back(std::move(*space));
  if (topic_of(report.one) == "triangle") {
    for (StepSpace& space : triangle_spaces(*report.walk, setting.camera)) spaces.push_back(std::move(space));
  }
  return spaces;
}

Setting ray_setting(const CaseReport& report) {
  const RayScene scene = scene_of(report.one, &report.exact, report.claim());
  Setting setting;
  setting.camera = scene.camera();
  const Views views = views_of(scene, report, setting.camera);
  setting.near = views.near;
  setting.wide = views.wide;
  setting.scene = items_of(scene.figure);
  setting.slider = slider_of(scene, setting.near, report);
  if (setting.wide.radius > 2.4 * setting.near.radius)
    setting.far_start = far_start(*setting.slider, setting.near, setting.camera);
  add_ray(setting.scene, scene.sight.question.ray, *setting.slider);
  const World world = scene.sight.world;
  setting.to_world = [world](const glm::dvec3& p) { return rounded(world.point(p)); };
  setting.spaces = spaces_of(report, setting);
  setting.has_inside = scene.figure.faces.size() != 1;
  setting.close_up = close_up_of(scene, report, setting.camera);
  return setting;
}

}  // namespace

Setting setting_of(const CaseReport& report) {
  const bool is_in_space = std::holds_alternative<RayQuestion>(report.one.question);
  Setting setting = is_in_space ? ray_setting(report) : flat_setting(report);
  setting.bindings = bindings_of(topic_of(report.one));
  return setting;
}

}  // namespace rayproof::viz
