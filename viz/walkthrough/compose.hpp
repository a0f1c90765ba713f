#pragma once
/// \file
/// What composed lessons are made of: library functions run in the recording arithmetic, shown as a kernel's
/// run is.

#include <algorithm>
#include <rayproof/arithmetics/recorded.hpp>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "viz/trace/record.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// The steps that `run(std::type_identity<R>{})` narrates in the recording arithmetic R of the precision.
template <class Run>
[[nodiscard]] Walkthrough record(Precision precision, Run&& run) {
  return in_precision(precision, [&]<class T>(T) {
    Tape tape;
    run(std::type_identity<Recorded<T, Shadow>>{});
    return steps_of(tape, precision);
  });
}

template <class R>
[[nodiscard]] Ray<R> named_ray(const Ray<double>& given) {
  Ray<R> ray = convert<R>(given);
  ray.origin = named("o", ray.origin);
  ray.direction = named("d", ray.direction);
  return ray;
}

template <class R>
[[nodiscard]] Vec2<R> named_point(const std::string& name, const Vec2<double>& p) {
  return {named((name + ".x").c_str(), R(p.x)), named((name + ".y").c_str(), R(p.y))};
}

/// The stage of a composed run: the given case's scene, a first step with the inputs, and the run's steps.
/// Each of the setting's bindings must draw something that the run records: std::logic_error.
[[nodiscard]] Stage composed_stage(const CaseReport& report, const Walkthrough& walk, const Setting& setting);

/// The same, and a last step on how far the run's own values differ from the exact ones.
[[nodiscard]] Stage run_stage(const CaseReport& report, const Walkthrough& walk, const Setting& setting);

/// The place of the step whose title begins so: std::logic_error where there is none.
template <class Steps>
[[nodiscard]] std::size_t place_of(const Steps& steps, std::string_view title) {
  const auto found = std::find_if(steps.begin(), steps.end(),
                                  [&](const auto& step) { return step.title.starts_with(title); });
  if (found == steps.end()) throw std::logic_error("no step '" + std::string(title) + "' in this run");
  return static_cast<std::size_t>(found - steps.begin());
}

/// The latest value of that name in a run: std::logic_error where there is none.
[[nodiscard]] const WalkValue& value_named(std::string_view name, const Walkthrough& walk);

/// A last step on how far the run's own values differ from the exact ones: the one that lost most, magnified.
[[nodiscard]] StageStep difference_of_values(const Walkthrough& walk, const Setting& setting,
                                             Precision precision);

/// A drawing in the plane of the screen, of its own scene.
[[nodiscard]] inline Setting plot_setting() {
  return {.camera = {.is_flat = true},
          .near = {{0, 0, 0}, 0.8},
          .wide = {{0, 0, 0}, 0.8},
          .to_world = [](const glm::dvec3& p) { return p; }};
}

/// The surface and the ray up to t_end, with a slider over the same.
[[nodiscard]] Setting surface_setting(const CaseReport& report, Items surface, double t_end);

/// From the steps of that title on, what was drawn before is shown no more.
void begin_anew(Stage& stage, std::string_view title);

}  // namespace rayproof::viz
