#include "bench/page/comparison_table.hpp"

#include <fmt/format.h>

#include "bench/page/text.hpp"
#include "case/escape.hpp"

namespace rayproof::report {

namespace {

/// The number of lines of a list that are shown; the number of all stands above it.
constexpr std::size_t shown = 40;

std::string name_of(const BenchRow& row) {
  return fmt::format("{}/{} {} {}, {}{}", row.shape, row.method, rayproof::name_of(row.precision),
                     name_of(row.arrangement), row.family, row.size > 0 ? fmt::format(" {}", row.size) : "");
}

std::string errors_of(const Accuracy& errors) {
  return fmt::format("{} wrong hits, {} wrong misses, {} ulp", errors.wrong_hits, errors.wrong_misses,
                     figure(errors.max_ulp));
}

std::string wronger(const Change& change) {
  return fmt::format("{}: {}; before {}", name_of(*change.now), errors_of(change.now->accuracy),
                     errors_of(change.before->accuracy));
}

std::string times(const Change& change) {
  return fmt::format("{}: {} ns, before {} ns: {:.2f} times as long", name_of(*change.now),
                     figure(change.now->ns_per_ray), figure(change.before->ns_per_ray), change.slowdown);
}

std::string summary_of(const ReportComparison& comparison, const std::string& machine) {
  std::string text = fmt::format(
      "{} rows are in both reports. A row takes {:.2f} times as long as before (the median); times below are "
      "without that. Before: {}.",
      comparison.rows, comparison.machines, machine);
  if (comparison.other > 0)
    text += fmt::format(" {} rows are of other cases than before: their errors are not compared.",
                        comparison.other);
  return text;
}

/// Calls `list(title, lines, left_out)` for each list.
template <class List>
void each_list(const ReportComparison& comparison, const List& list) {
  const auto give = [&](const char* title, const std::vector<Change>& changes,
                        std::string (*line_of)(const Change&)) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::min(changes.size(), shown); ++i) lines.push_back(line_of(changes[i]));
    if (changes.size() > shown) lines.push_back(fmt::format("and {} more", changes.size() - shown));
    list(fmt::format("{}: {}", title, changes.empty() ? "none" : std::to_string(changes.size())), lines);
  };
  give("Wronger than before", comparison.wronger, wronger);
  give("Slower", comparison.slower, times);
  give("Faster", comparison.faster, times);
}

}  // namespace

std::string comparison_in_text(const ReportComparison& comparison, const std::string& machine) {
  std::string text = "Beside the baseline\n" + summary_of(comparison, machine) + "\n";
  if (comparison.rows == 0) return text;
  each_list(comparison, [&](const std::string& title, const std::vector<std::string>& lines) {
    text += title + "\n";
    for (const std::string& one : lines) text += "  " + one + "\n";
  });
  return text;
}

std::string comparison_in_html(const ReportComparison& comparison, const std::string& machine) {
  std::string html = "<h2 id=\"baseline\">Beside the baseline</h2>\n<p>" +
                     escaped(summary_of(comparison, machine)) + "</p>\n";
  if (comparison.rows == 0) return html;
  each_list(comparison, [&](const std::string& title, const std::vector<std::string>& lines) {
    html += "<h3>" + escaped(title) + "</h3>\n";
    if (lines.empty()) return;
    html += "<ul>\n";
    for (const std::string& one : lines) html += "<li>" + escaped(one) + "</li>\n";
    html += "</ul>\n";
  });
  return html;
}

}  // namespace rayproof::report
