#include "viz/walkthrough/difference_gap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/scene/fit_view.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/magnifier.hpp"

namespace rayproof::viz {

std::optional<Gap> gap_of(const CaseReport& report) {
  if (!report.walk || report.walk->steps.empty()) return std::nullopt;
  const NumbersByName n(*report.walk, report.walk->steps.size() - 1);
  const auto& [entry, exit, padded] = gap_names;
  if (!n.has(exit)) return std::nullopt;
  const Gap gap{n[entry], n[exit], n.rounded(entry), n.rounded(n.has(padded) ? padded : exit)};
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
  const auto interval = [&](Role role, const glm::dvec3& off, double a, double b, const std::string& word) {
    const bool is_empty = b < a;
    step.items.push_back(segment(role, magnifier.at(a) + off, magnifier.at(b) + off,
                                 is_empty ? "nothing between" : "inside",
                                 is_empty ? Pattern::dotted : Pattern::solid));
    step.items.push_back(point(role, magnifier.at(a) + off, "entry " + word));
    step.items.push_back(point(role, magnifier.at(b) + off, "exit " + word));
  };
  step.is_apart = true;
  step.magnification = 1 / (magnifier.unit * glm::length(direction));
  step.items = {arrow(Role::ray, -magnified_reach * magnifier.along, magnified_reach * magnifier.along)};
  for (StageItem& dot : dots_of(magnifier, gap.computed_entry, precision)) step.items.push_back(dot);
  interval(Role::exact, aside, gap.entry, gap.exit, "exact");
  interval(Role::claimed, -aside, gap.computed_entry, gap.computed_exit, "as computed");
  step.view = view_of(extent_of(step.items, setting.camera), setting.camera);
}

std::string in_words(const Gap& gap, Precision precision) {
  const auto interval = [](double entry, double exit, Precision shown_in) {
    return fmt::format("in at {}, out at {}", shown(entry, shown_in), shown(exit, shown_in));
  };
  return fmt::format("Exactly the ray is {}; computed, {}. {}",
                     interval(gap.entry, gap.exit, Precision::float64),
                     interval(gap.computed_entry, gap.computed_exit, precision), dots_in_words(precision));
}

}  // namespace rayproof::viz
