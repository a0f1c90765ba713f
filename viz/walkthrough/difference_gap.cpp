#include "viz/walkthrough/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {

std::optional<Gap> gap_of(const CaseReport& report) {
  if (!report.walk || report.walk->steps.empty()) return std::nullopt;
  const NumbersByName n(*report.walk, report.walk->steps.size() - 1);
  const auto& [entry, exit, padded] = gap_names;
  if (!n.has(exit)) return std::nullopt;
  const char* const computed_exit = n.has(padded) ? padded : exit;
  const Gap gap{n[entry], n[exit], n.rounded(entry), n.rounded(computed_exit), computed_exit};
  const double size = std::abs(gap.exit - gap.entry);
  const bool is_narrow = size > 0 && size < 1e-3 * std::abs(gap.entry) && std::isfinite(gap.computed_exit);
  return is_narrow ? std::optional(gap) : std::nullopt;
}

void show_gap(StageStep& step, const Gap& gap, Precision precision, const Setting& setting) {
  const glm::dvec3& direction = setting.slider->direction;
  const double from = std::min({gap.entry, gap.exit, gap.computed_entry, gap.computed_exit});
  const double to = std::max({gap.entry, gap.exit, gap.computed_entry, gap.computed_exit});
  const Magnifier magnifier{from + (to - from) / 2, (to - from) / 4, setting.camera.right};
  const glm::dvec3 aside = 0.7 * setting.camera.up;
  const auto interval = [&](Role role, const glm::dvec3& off, double a, double b, const std::string& exit,
                            const std::string& word) {
    const bool is_empty = b < a;
    step.items.push_back(segment(role, magnifier.at(a) + off, magnifier.at(b) + off,
                                 is_empty ? "nothing between" : "inside",
                                 is_empty ? Pattern::dotted : Pattern::solid));
    step.items.push_back(point(role, magnifier.at(a) + off, gap_names[0] + (" " + word)));
    step.items.push_back(point(role, magnifier.at(b) + off, exit + " " + word));
  };
  step.is_apart = true;
  step.magnification = 1 / (magnifier.unit * glm::length(direction));
  step.items = {arrow(Role::ray, -magnified_reach * magnifier.along, magnified_reach * magnifier.along)};
  append(step.items, dots_of(magnifier, gap.computed_entry, precision));
  interval(Role::exact, aside, gap.entry, gap.exit, gap_names[1], "exact");
  interval(Role::claimed, -aside, gap.computed_entry, gap.computed_exit, gap.computed_exit_name,
           "as computed");
  step.view = view_of(extent_of(step.items, setting.camera), setting.camera);
}

std::optional<StepSpace> padded_space(const CaseReport& report, const StageCamera& camera) {
  const std::optional<Gap> gap = gap_of(report);
  const auto& question = std::get<RayQuestion>(report.one.question);
  const auto* box = std::get_if<rayproof::Box<double>>(&question.shape);
  if (!gap || box == nullptr || !report.walk->steps.back().title.starts_with("Move the far end on"))
    return std::nullopt;
  const glm::dvec3 d = question.ray.direction;
  const glm::dvec3 below = (box->min - question.ray.origin) / d, above = (box->max - question.ray.origin) / d;
  int in = 0, out = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::min(below[i], above[i]) > std::min(below[in], above[in])) in = i;
    if (std::max(below[i], above[i]) < std::max(below[out], above[out])) out = i;
  }
  if (in == out) return std::nullopt;
  const double unit = std::abs(d[out]) * (gap->computed_exit - gap->exit);
  // The edge is at 0; the ray enters across the plane x = 0 and leaves across y = 0.
  const auto at = [=, gap = *gap](double t) {
    return glm::dvec3(std::abs(d[in]) * (t - gap.entry), std::abs(d[out]) * (t - gap.exit), 0) / unit;
  };
  constexpr double wide = 3.2, high = 2;
  const glm::dvec3 run = at(gap->exit + (gap->computed_exit - gap->exit) * 2) - at(gap->exit);
  const auto scene = [=, gap = *gap](const NumbersByName& /*n*/) {
    return Items{open_polygon(Role::surface, {{0, 0, 0}, {wide, 0, 0}, {wide, -high, 0}, {0, -high, 0}}),
                 polyline(Role::surface, {{0, -high, 0}, {0, 0, 0}, {wide, 0, 0}}),
                 point(Role::text, {0.6 * wide, -0.5 * high, 0}, "the box"),
                 arrow(Role::ray, at(gap.exit) - run, at(gap.exit) + run, "p(t)"),
                 point(Role::nearest, at(gap.exit), "t_exit"),
                 point(Role::nearest, at(gap.entry), "t_entry")};
  };
  const auto padding = [=, gap = *gap](const NumbersByName& /*n*/) {
    return Items{open_polygon(Role::claimed, {{0, 0, 0}, {wide, 0, 0}, {wide, 1, 0}, {0, 1, 0}}),
                 polyline(Role::claimed, {{0, 0, 0}, {0, 1, 0}, {wide, 1, 0}}, "padded"),
                 point(Role::claimed, at(gap.computed_exit), "t_padded")};
  };
  return StepSpace{report.walk->steps.back().title,
                   "Drawn in the plane across the edge that the ray nearly touches.",
                   scene,
                   flat_on(camera),
                   {{"t_padded", padding}},
                   true,
                   1 / unit};
}

std::string in_words(const Gap& gap, Precision precision) {
  const auto interval = [](double entry, const char* exit_name, double exit, Precision shown_in) {
    return fmt::format("{} = {} and {} = {}", gap_names[0], shown(entry, shown_in), exit_name,
                       shown(exit, shown_in));
  };
  return fmt::format("Exactly, {}; computed, {}. {}",
                     interval(gap.entry, gap_names[1], gap.exit, Precision::float64),
                     interval(gap.computed_entry, gap.computed_exit_name, gap.computed_exit, precision),
                     dots_in_words(precision));
}

Items dots_of(const Magnifier& magnifier, double around, Precision precision) {
  Items items;
  for (const int next : {-1, 1}) {
    double t = next > 0 ? neighbour_of(around, next, precision) : around;
    for (int i = 0; i < 8 && std::abs(t - magnifier.centre) <= magnified_reach * magnifier.unit; ++i) {
      items.push_back(point(Role::muted, magnifier.at(t)));
      t = neighbour_of(t, next, precision);
    }
  }
  return items;
}

std::string dots_in_words(Precision precision) {
  return fmt::format("Each dot is a {} value.", name_of(precision));
}

}  // namespace rayproof::viz
