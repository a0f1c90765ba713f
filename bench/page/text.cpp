#include "bench/page/text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bench/page/choice_table.hpp"
#include "bench/page/comparison_table.hpp"
#include "bench/page/scaling_svg.hpp"

namespace rayproof::report {

std::string figure(double x) {
  if (std::isnan(x)) return "-";
  if (std::isinf(x)) return "inf";
  return fmt::format("{:.3g}", x);
}

std::string nanoseconds(double ns) { return ns < 1000 ? figure(ns) : fmt::format("{:.0f}", ns); }

std::string to_text(const Conclusions& found) {
  const auto& [figures, summaries, choices, plots, baseline] = found;
  std::string text = fmt::format("{}; {}\n", figures.machine, figures.compiler);
  std::string group;
  for (const MethodSummary& one : summaries) {
    const std::string own_group = fmt::format("{} {}", one.shape, name_of(one.precision));
    if (own_group != group) {
      group = own_group;
      text += fmt::format("\n{:<22} {:<7} {:>7} {:>7} {:>10} {:>12} {:>8} {:>8} {:>9} {:>5} {:>6} {:>6}\n",
                          group, "", "ns/ray", "cases", "wrong hits", "wrong misses", "max ulp", "p99 ulp",
                          "mean bits", "point", "normal", "coord.");
    }
    text += fmt::format("{:<22} {:<7} {:>7}", one.method, name_of(one.arrangement), figure(one.ns_per_ray));
    const Accuracy& errors = one.accuracy;
    if (one.has_errors())
      text += fmt::format(" {:>7} {:>10} {:>12} {:>8} {:>8} {:>9} {:>5} {:>6} {:>6}", errors.cases,
                          errors.wrong_hits, errors.wrong_misses, figure(errors.max_ulp),
                          figure(errors.p99_ulp), figure(errors.mean_bits), figure(errors.max_point),
                          figure(errors.max_normal), figure(errors.max_coordinates));
    text += '\n';
  }
  if (const auto of_sphere = headline(figures.rows))
    text += fmt::format("\n{}\n", sentence(*of_sphere, figures.rays));
  text += scaling_in_text(figures.scaling);
  if (!choices.empty()) text += "\n" + choices_in_text(choices);
  if (baseline) text += "\n" + comparison_in_text(baseline->first, baseline->second);
  return text;
}

}  // namespace rayproof::report
