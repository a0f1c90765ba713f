#include "properties/report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "properties/report/grid.hpp"

namespace rayproof {

namespace {

constexpr std::array<std::pair<const char*, double Worst::*>, 3> measures{
    {{"verdict band", &Worst::verdict}, {"residual", &Worst::residual}, {"ulp", &Worst::ulp}}};

/// Subjects of a topic in the plan's order.
std::vector<const Subject*> subjects_of(const Plan& plan, const std::string& topic) {
  std::vector<const Subject*> of_topic;
  for (const Subject* subject : plan.subjects)
    if (subject->topic == topic) of_topic.push_back(subject);
  return of_topic;
}

/// The worst error over the precisions; nothing where it was not measured.
std::string worst_of(const RunResult& result, const Subject* subject, const Family* family,
                     double Worst::*measure) {
  Worst worst;
  for (const UnitResult& unit : result.units)
    if (unit.subject == subject && unit.family == family) worst += unit.tally.worst;
  return worst.cases == 0 ? "" : figure(worst.*measure);
}

}  // namespace

std::string text_families(const Plan& plan, const RunResult& result) {
  std::string text;
  std::string last_topic;
  for (const Family* first : plan.families) {
    if (first->topic == last_topic) continue;
    last_topic = first->topic;
    const auto of_topic = subjects_of(plan, first->topic);
    for (const auto& [name, measure] : measures) {
      Grid grid;
      std::vector<std::string> head{fmt::format("{}: worst {}", first->topic, name)};
      for (const Subject* subject : of_topic) head.push_back(subject->name);
      grid.add(head);
      for (const Family* family : plan.families) {
        if (family->topic != first->topic) continue;
        std::vector<std::string> line{family->name};
        for (const Subject* subject : of_topic) line.push_back(worst_of(result, subject, family, measure));
        grid.add(line);
      }
      text += grid.text() + "\n";
    }
  }
  return text;
}

std::string text_labels(const RunResult& result) {
  Grid grid;
  grid.add({"family", "precision", "labels"});
  for (const LabelCount& labels : result.labels)
    grid.add({labels.family->topic + "/" + labels.family->name, name_of(labels.precision), labels.shares()});
  return grid.text();
}

std::string text_measured(const Summary& summary) {
  std::string text;
  for (const Row& row : summary.rows)
    if (row.is_measured)
      text += fmt::format(
          "{} {}: .verdict = {{.measured = {:.3g}}}, .residual = {{.measured = {:.3g}}}, "
          ".ulp = {{.measured = {:.3g}}}  // {} wrong verdicts in {} cases of the domain\n",
          row.subject->full_name(), name_of(row.precision), row.worst.verdict, row.worst.residual,
          row.worst.ulp, row.worst.wrong, row.worst.cases);
  return text;
}

}  // namespace rayproof
