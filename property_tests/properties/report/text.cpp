#include "properties/report/report.hpp"

#include <fmt/format.h>

#include <utility>

#include "properties/report/grid.hpp"

namespace rayproof {

namespace {

constexpr std::array<std::pair<const char*, double Worst::*>, 6> measures{
    {{"verdict band", &Worst::verdict},
     {"residual", &Worst::residual},
     {"ulp", &Worst::ulp},
     {"point", &Worst::point},
     {"normal", &Worst::normal},
     {"coordinates", &Worst::coordinates}}};

/// The worst error over the precisions; nothing where it was not measured.
std::string worst_of(const RunResult& result, const Subject* subject, const Family* family,
                     double Worst::*measure) {
  Worst worst;
  for (const Unit& unit : result.units)
    if (unit.subject == subject && unit.family == family) worst += unit.tally.worst;
  return worst.cases == 0 ? "" : figure(worst.*measure);
}

/// The families of a topic below one another, its subjects side by side.
std::string table_of(const Plan& plan, const RunResult& result, const std::string& topic, const char* name,
                     double Worst::*measure) {
  Rows rows{{fmt::format("{}: worst {}", topic, name)}};
  for (const Subject* subject : plan.subjects)
    if (subject->topic == topic) rows.front().push_back(subject->name);
  for (const Family* family : plan.families) {
    if (family->topic != topic) continue;
    rows.push_back({family->name});
    for (const Subject* subject : plan.subjects)
      if (subject->topic == topic) rows.back().push_back(worst_of(result, subject, family, measure));
  }
  return in_columns(rows);
}

/// The part of the first hit's bounds, where they were measured.
std::string measured_hit(const Worst& worst) {
  if (worst.details == 0) return "";
  return fmt::format(
      ", .hit = {{.point = {{.measured = {:.3g}}}, .normal = {{.measured = {:.3g}}}, "
      ".coordinates = {{.measured = {:.3g}}}}}",
      worst.point, worst.normal, worst.coordinates);
}

}  // namespace

std::string text_families(const Plan& plan, const RunResult& result) {
  std::string text;
  std::string last_topic;
  for (const Family* family : plan.families)
    if (std::exchange(last_topic, family->topic) != family->topic)
      for (const auto& [name, measure] : measures)
        text += table_of(plan, result, family->topic, name, measure) + "\n";
  return text;
}

std::string text_labels(const RunResult& result) {
  Rows rows{{"family", "precision", "labels"}};
  for (const LabelCount& labels : result.labels)
    rows.push_back(
        {labels.family->topic + "/" + labels.family->name, name_of(labels.precision), labels.shares()});
  return in_columns(rows);
}

std::string text_measured(const Summary& summary) {
  std::string text;
  for (const Row& row : summary.rows)
    if (row.is_measured())
      text += fmt::format(
          "{} {}: .verdict = {{.measured = {:.3g}}}, .residual = {{.measured = {:.3g}}}, "
          ".ulp = {{.measured = {:.3g}}}{}  // {} wrong verdicts in {} cases of the domain\n",
          row.subject->full_name(), name_of(row.precision), row.worst.verdict, row.worst.residual,
          row.worst.ulp, measured_hit(row.worst), row.worst.wrong, row.worst.cases);
  return text;
}

}  // namespace rayproof
