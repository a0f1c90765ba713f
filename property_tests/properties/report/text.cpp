#include "properties/report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "case/writer.hpp"
#include "properties/report/commands.hpp"
#include "properties/report/grid.hpp"

namespace rayproof {

namespace {

constexpr std::array<std::pair<const char*, double Worst::*>, 3> measures{
    {{"verdict band", &Worst::verdict}, {"residual", &Worst::residual}, {"ulp", &Worst::ulp}}};

/// The properties that some subject has a mark for.
std::vector<std::size_t> columns_in_use(const Summary& summary) {
  std::vector<std::size_t> used;
  for (std::size_t p = 0; p < properties().size(); ++p)
    if (std::any_of(summary.rows.begin(), summary.rows.end(),
                    [&](const Row& row) { return row.cells[p].mark != Mark::unclaimed; }))
      used.push_back(p);
  return used;
}

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

std::string text_table(const Summary& summary) {
  const std::vector<std::size_t> columns = columns_in_use(summary);
  Grid grid;
  std::vector<std::string> head{"method", "precision", "cases"};
  for (const std::size_t p : columns) head.emplace_back(properties()[p].name);
  for (const auto& [name, measure] : measures) head.push_back(std::string("worst ") + name);
  grid.add(head);
  for (const Row& row : summary.rows) {
    std::vector<std::string> line{row.subject->full_name(), name_of(row.precision),
                                  fmt::format("{}", row.cases)};
    for (const std::size_t p : columns) line.emplace_back(sign_of(row.cells[p].mark));
    const Contract& contract = row.subject->contract;
    line.push_back(row.is_measured ? figure(row.worst.verdict, contract.verdict.promised) : "");
    line.push_back(row.is_measured ? figure(row.worst.residual, contract.residual.promised) : "");
    line.push_back(row.is_measured ? figure(row.worst.ulp, contract.ulp.promised) : "");
    grid.add(line);
  }
  std::string legend;
  for (const Mark mark :
       {Mark::holds, Mark::refuted, Mark::broken, Mark::unrefuted, Mark::spared, Mark::untested})
    legend += fmt::format("{}{} {}", legend.empty() ? "" : "   ", sign_of(mark), word_of(mark));
  return grid.text() + legend + "\n";
}

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
  for (const LabelCount& labels : result.labels) {
    std::string shares;
    for (const auto& [label, count] : labels.counts)
      shares += fmt::format("{}{} {:.1f} %", shares.empty() ? "" : ", ", label, 100 * labels.share(label));
    grid.add({labels.family->topic + "/" + labels.family->name, name_of(labels.precision), shares});
  }
  return grid.text();
}

std::string text_finding(const Finding& finding) {
  return fmt::format("{} {} {} ({}): {}\n  {}\n  {}\n",
                     finding.is_declared ? "refuted as declared:" : "BROKEN:", finding.subject->full_name(),
                     finding.property->name, finding.family, finding.evidence.note, write_case(finding.one),
                     walk_command(finding));
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
