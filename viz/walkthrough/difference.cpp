#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/setting.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

/// A gap narrower than this, in the view's radii, can't be seen.
constexpr double visible_gap = 0.05;

const Answer& finest(const CaseReport& report) { return report.finer ? *report.finer : report.exact; }

/// The values that lie farthest apart, the exact one rounded to float64.
std::optional<ValuePair> worst_pair_of(const CaseReport& report) {
  std::optional<ValuePair> worst = worst_pair(&report.exact, report.claim(), report.one.precision);
  const std::vector<double> fine = values_of(&finest(report));
  if (!worst || worst->rank >= fine.size()) return std::nullopt;
  worst->exact = fine[worst->rank];
  return worst;
}

/// The surface at the exact hit in profile, where the ray runs to the right: from so near it is level.
Items surface_at_hit(const glm::dvec3& normal, const Setting& setting) {
  const double facing = glm::dot(normal, glm::normalize(setting.slider->direction));
  const double aside =
      std::copysign(std::sqrt(std::max(0.0, 1 - facing * facing)), glm::dot(normal, setting.camera.up));
  const auto at = [&](double x, double y) { return x * setting.camera.right + y * setting.camera.up; };
  const glm::dvec3 out = at(facing, aside);
  const glm::dvec3 along = at(-aside, facing);
  constexpr double reach = 12;
  Items items{segment(Role::surface, -reach * along, reach * along)};
  if (setting.has_inside) {
    items.push_back(open_polygon(
        Role::surface, {-reach * along, reach * along, reach * (along - out), -reach * (along + out)}));
  }
  return items;
}

/// The curve at a root, its slope not to scale; at a double root it touches the axis.
Items curve_at_root(const Quadratic<double>& q, double root, const Setting& setting) {
  if (q.b * q.b == 4 * q.a * q.c) {
    std::vector<glm::dvec3> arc;
    for (double x = -3.4; x <= 3.4; x += 0.2)
      arc.push_back(x * setting.camera.right + std::copysign(0.1 * x * x, q.a) * setting.camera.up);
    return {polyline(Role::surface, arc)};
  }
  const double slope = 2 * q.a * root + q.b < 0 ? -0.5 : 0.5;
  const glm::dvec3 end = 3.4 * (setting.camera.right + slope * setting.camera.up);
  return {segment(Role::surface, -end, end)};
}

/// The stretch of the ray around one hit, so near that single numbers can be distinguished.
void magnify(StageStep& step, const CaseReport& report, const ValuePair& pair, const Setting& setting) {
  const bool is_ray = std::holds_alternative<RayQuestion>(report.one.question);
  const double up = neighbour_of(pair.claimed, 1, report.one.precision);
  const double ulp = std::isinf(up) ? pair.claimed - neighbour_of(pair.claimed, -1, report.one.precision)
                                    : up - pair.claimed;
  const double gap = std::abs(pair.claimed - pair.exact);
  const double unit = std::max(gap / 2, ulp);
  const double speed = is_ray ? glm::length(setting.slider->direction) : 1;
  const Magnifier magnifier{pair.exact, unit, setting.camera.right};
  step.is_apart = true;
  step.magnification = 1 / (unit * speed);
  const auto* answer = std::get_if<RayAnswer>(&report.exact);
  // From farther off a surface is not level.
  const bool is_level = unit * speed < 0.02 * setting.near.radius;
  const bool is_inside_face =
      answer != nullptr && (answer->contact == Contact::crossing || answer->contact == Contact::tangent);
  if (is_inside_face && answer->normal && pair.rank == 0 && is_level)
    step.items = surface_at_hit(*answer->normal, setting);
  if (const auto* q = std::get_if<Quadratic<double>>(&report.one.question))
    step.items = curve_at_root(*q, pair.exact, setting);
  step.items.push_back(arrow(Role::ray, -3.3 * magnifier.along, 3.3 * magnifier.along));
  if (ulp > unit / 6) {
    append(step.items, dots_of(magnifier, pair.claimed, report.one.precision));
    step.caption += " " + dots_in_words(report.one.precision);
  }
  if (gap > unit / 2) {
    const glm::dvec3 above = 0.5 * setting.camera.up;
    step.items.push_back(
        segment(Role::nearest, above, magnifier.at(pair.claimed) + above, "off by " + rough(gap, 2)));
  }
  const std::string name = root_name(report, pair.rank);
  step.items.push_back(point(Role::exact, {0, 0, 0}, name + " exact"));
  step.items.push_back(point(Role::claimed, magnifier.at(pair.claimed), name + " as computed"));
  // As far as the numbers go: the surface goes on.
  step.view = {glm::dvec3(0), (magnified_reach + 0.1) / view_aspect};
}

/// "The computed t₀ is off by 2 ulps, counted from the exact one correctly rounded: exact 4.87997734 (to 53
/// bits), computed 4.8799777 (float32)."
std::string pair_in_words(const CaseReport& report, const ValuePair& pair) {
  const char* const format = name_of(report.one.precision);
  constexpr double many = 100;  // it is no matter then
  const bool is_counted = pair.ulps > 0 && pair.ulps < many;
  return fmt::format(
      "The computed {} is {}{}: exact {} (to 53 bits), computed {} ({}).", root_name(report, pair.rank),
      accuracy_in_words(pair.ulps), is_counted ? ", counted from the exact one correctly rounded" : "",
      shown(pair.exact, Precision::float64), shown(pair.claimed, report.one.precision), format);
}

/// " Exact: t₀ = 1. Computed: t₀ = 1, t₁ = 2." of the answers that have a number.
std::string hits_in_words(const CaseReport& report) {
  std::string words;
  for (const auto& [who, answer] : {std::pair{"Exact", &report.exact}, {"Computed", report.claim()}}) {
    const std::vector<double> values = values_of(answer);
    for (std::size_t i = 0; i < values.size(); ++i) {
      words += i == 0 ? fmt::format(" {}: ", who) : ", ";
      words += fmt::format("{} = {}", root_name(report, i), shown(values[i], report.one.precision));
    }
    if (!values.empty()) words += ".";
  }
  return words;
}

bool is_hidden(const ValuePair& pair, const Setting& setting) {
  if (!setting.slider) return false;
  const double gap = std::abs(pair.claimed - pair.exact) * glm::length(setting.slider->direction);
  return gap > 0 && gap < visible_gap * setting.near.radius;
}

std::string verdict_in_words(const CaseReport& report) {
  const std::string exact = verdict_of(&report.exact);
  if (report.claim() == nullptr) return fmt::format("The exact answer: {}.", exact);
  const std::string claimed = verdict_of(report.claim());
  const bool differ = verdicts_differ(&report.exact, report.claim());
  return differ
             ? fmt::format("Float result and exact result differ. Exact: {}. Computed: {}.", exact, claimed)
             : fmt::format("Float result and exact result are the same: {}.", exact);
}

/// What the conclusion says beside how near the answer is, which the step says itself.
std::string why_in_words(const CaseReport& report) {
  const std::string all = conclusion_of(report);
  if (!all.starts_with("The answer is ")) return all;
  const std::size_t end = all.find(". ");
  return end == std::string::npos ? "" : all.substr(end + 2);
}

}  // namespace

Items hits_of(const StageSlider& slider, const CaseReport& report) {
  Items items;
  for (const auto& [role, answer, word] : {std::tuple{Role::exact, &finest(report), "exact"},
                                           std::tuple{Role::claimed, report.claim(), "as computed"}}) {
    const std::vector<double> values = values_of(answer);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isfinite(values[i]))
        items.push_back(
            point(role, slider.origin + values[i] * slider.direction, root_name(report, i) + " " + word));
    }
  }
  return items;
}

StageStep difference_step(const CaseReport& report, const Setting& setting) {
  StageStep step{.title = report.claim() == nullptr ? "The exact answer" : comparison_title,
                 .digits = why_in_words(report),
                 .view = setting.near};
  const auto show_all = [&] {
    if (setting.slider) step.items = hits_of(*setting.slider, report);
  };
  const bool differ = verdicts_differ(&report.exact, report.claim());
  const std::optional<ValuePair> pair = worst_pair_of(report);
  if (!differ && pair) {
    step.caption = pair_in_words(report, *pair);
    if (std::isfinite(pair->claimed - pair->exact)) {
      magnify(step, report, *pair, setting);
    } else {
      show_all();
    }
    return step;
  }
  if (const auto gap = gap_of(report)) {
    show_gap(step, *gap, report.one.precision, setting);
    step.caption = verdict_in_words(report) + " " + in_words(*gap, report.one.precision);
    return step;
  }
  step.caption = verdict_in_words(report);
  if (setting.close_up && setting.close_up->gap > 0 &&
      setting.close_up->gap < visible_gap * setting.near.radius) {
    step.is_apart = true;
    step.magnification = 1 / setting.close_up->gap;
    step.view = close_up_view;
    step.items = setting.close_up->items;
    step.caption += " " + setting.close_up->words + hits_in_words(report);
    return step;
  }
  if (differ && pair && is_hidden(*pair, setting)) {
    step.caption += " " + pair_in_words(report, *pair);
    magnify(step, report, *pair, setting);
    return step;
  }
  show_all();
  return step;
}

}  // namespace rayproof::viz
