#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

double lost_by(const StageValue& value) { return worst_component(value).bits_lost; }

/// Of the run's values that are computed, the one that lost most.
std::optional<StageValue> worst_of(const Walkthrough& walk) {
  std::optional<StageValue> worst;
  for (const WalkStep& step : walk.steps) {
    for (const StageValue& value : grouped(step.values)) {
      if (value.components.front().formula != nullptr && (!worst || lost_by(value) > lost_by(*worst)))
        worst = value;
    }
  }
  return worst;
}

/// How far the value is off, as an arrow in the world or along the picture's right.
glm::dvec3 error_of(const StageValue& value, const Setting& setting) {
  const auto error = [&](std::size_t i) {
    return i < value.components.size() ? value.components[i].error : 0.0;
  };
  if (value.components.size() > 1) return {error(0), error(1), error(2)};
  return error(0) * setting.camera.right;
}

}  // namespace

StageStep difference_of_values(const Walkthrough& walk, const Setting& setting, Precision precision) {
  StageStep step;
  step.title = comparison_title;
  step.view = setting.near;
  const auto worst = worst_of(walk);
  if (!worst || lost_by(*worst) == 0) {
    step.caption = "Float result and exact result are the same: no value of this run is rounded.";
    return step;
  }
  step.caption = fmt::format("Of all values {} lost the most, {:.1f} of {} bits: exact {}, computed {}.",
                             worst->name, lost_by(*worst), worst_component(*worst).digits, exact_of(*worst),
                             shown(*worst, precision));
  const glm::dvec3 error = error_of(*worst, setting);
  const double size = glm::length(error);
  if (!(size > 0) || !std::isfinite(size)) return step;
  step.is_apart = true;
  step.magnification = 1.5 / size;
  const glm::dvec3 tip = 1.5 / size * error;
  step.view = {0.5 * tip, 0.75};  // room for the words at both ends
  step.items = {segment(Role::edge, {0, 0, 0}, tip, "off by " + rough(size, 3)),
                point(Role::exact, {0, 0, 0}, worst->name + " exact"),
                point(Role::claimed, tip, worst->name + " as computed")};
  return step;
}

}  // namespace rayproof::viz
