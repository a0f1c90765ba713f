#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <rayproof/roots.hpp>
#include <rayproof/spawn.hpp>
#include <rayproof/sphere/centred.hpp>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

double height_of(const glm::vec3& point, const Sphere<double>& sphere) {
  const glm::dvec3 f = glm::dvec3(point) - sphere.center;
  return std::sqrt(dot(f, f)) - sphere.radius;
}

/// Where a hit's next ray starts, and what becomes of it.
struct Start {
  double height;  ///< over the surface
  double next;    ///< the t of the next ray's first hit with the same sphere, infinite for none
  double climb;   ///< how much it rises for each length that it goes
};

template <class Strategy>
Start start_by(const spawn::SurfacePoint<float>& from, const glm::vec3& direction,
               const Sphere<double>& sphere) {
  const glm::vec3 origin = Strategy::origin(from);
  const auto next = convert<Shadow>(Ray<double>{glm::dvec3(origin), glm::dvec3(direction)});
  const Roots<Shadow> roots = sphere::Centred::roots(next, convert<Shadow>(sphere));
  const double t = in_interval(next, roots.lo)   ? static_cast<double>(roots.lo)
                   : in_interval(next, roots.hi) ? static_cast<double>(roots.hi)
                                                 : infinity<double>;
  return {height_of(origin, sphere), t,
          static_cast<double>(glm::dot(direction, from.normal)) / glm::length(glm::dvec3(direction))};
}

/// Above its surface, enlarged: the hit p, and o′ straight over or below it.
template <class Strategy>
StageStep start_step(const spawn::SurfacePoint<float>& from, const glm::vec3& direction,
                     const Sphere<double>& sphere, const StageCamera& camera) {
  const Start start = start_by<Strategy>(from, direction, sphere);
  const double hit = height_of(from.hit, sphere);
  const double size = std::max(std::abs(hit), std::abs(start.height));
  const auto at = [&](double sideways, double height) {
    return sideways * camera.right + height / size * camera.up;
  };
  const bool is_acne = std::isfinite(start.next);
  StageStep step;
  step.title = fmt::format("Start by '{}', {}", Strategy::name, Strategy::title);
  step.words =
      fmt::format("The start o′ is {} {} the surface. The exact next ray {}",
                  rough(std::abs(start.height), 3), start.height < 0 ? "below" : "above",
                  is_acne ? fmt::format("meets the sphere again at t = {}: acne.", rough(start.next, 3))
                          : "does not meet the sphere again.");
  const bool has_moved = start.height != hit;
  if (!has_moved && !std::is_same_v<Strategy, spawn::Nothing>)
    step.words.insert(0, "The offset is rounded away: o′ is p. ");
  step.caption = step.words;
  step.is_apart = true;
  step.magnification = 1 / size;
  const double rise = std::clamp(start.climb, 0.2, 0.8) * size;
  const double low = std::min({hit, start.height, -0.3 * size}) / size;
  const double high = std::max(start.height + 0.9 * rise, 0.3 * size) / size;
  step.view = {0.5 * (low + high) * camera.up, 0.5 * (high - low) + 0.5};
  step.items = ground_of(camera);
  const glm::dvec3 from_p = at(-0.6, hit), from_o = at(-0.6, start.height);
  append(step.items, {point(Role::text, at(1.6, -0.15 * size), "the sphere"),
                      point(Role::nearest, from_p, has_moved ? "p" : ""),
                      point(Role::claimed, from_o, has_moved ? "o′" : "o′ = p"),
                      arrow(Role::ray, from_o, at(0.3, start.height + 0.9 * rise), "the next ray")});
  if (has_moved) step.items.push_back(segment(Role::normal, from_p, from_o, "the offset"));
  if (is_acne)
    step.items.push_back(point(Role::claimed, at(-0.6 - start.height / rise, 0), "its own surface again"));
  return step;
}

}  // namespace

/// A rounded hit lies inside; where the next ray starts decides whether it meets its own surface.
Stage acne_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/centred");
  const auto& question = std::get<RayQuestion>(one.question);
  const auto& sphere = std::get<Sphere<double>>(question.shape);
  const Ray<float> ray = convert<float>(question.ray);
  const auto t = static_cast<float>(std::get<RayAnswer>(report.exact).hits.t[0]);
  const glm::vec3 hit = point_at(ray, t);
  const spawn::SurfacePoint<float> from = spawn::leave(convert<float>(sphere), hit);
  const glm::vec3 direction = ray.direction - 2 * glm::dot(ray.direction, from.normal) * from.normal;
  Stage stage = stage_of(report);
  const StageStep given = stage.steps.front();
  stage.steps = {given};
  StageStep& rounded = stage.steps.emplace_back(given);
  rounded.values.clear();
  rounded.title = "Round the hit in each coordinate";
  const double height = height_of(hit, sphere);
  rounded.words = fmt::format("t₀ = {} is the exact one, rounded; still p(t₀) is {} {} the surface.",
                              shown(static_cast<double>(t), one.precision), rough(std::abs(height), 3),
                              height < 0 ? "below" : "above");
  rounded.caption = rounded.words;
  rounded.items = {
      point(Role::claimed, glm::dvec3(hit), "p"),
      arrow(Role::normal, glm::dvec3(hit),
            glm::dvec3(hit + static_cast<float>(0.4 * sphere.radius) * from.normal), "n"),
      arrow(Role::edge, glm::dvec3(hit),
            glm::dvec3(hit) + resized(glm::dvec3(direction), 0.8 * sphere.radius), "the next ray")};
  spawn::Strategies::for_each([&]<class Strategy>(std::type_identity<Strategy>) {
    stage.steps.push_back(start_step<Strategy>(from, direction, sphere, stage.camera));
  });
  stage.conclusion =
      "A fixed offset fails where the coordinates are large; a proven one follows from their rounding.";
  stage.steps.back().digits = stage.conclusion;
  return stage;
}

}  // namespace rayproof::viz
