#include "dossier/bug_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace rayproof::dossier {
namespace {

constexpr std::chrono::milliseconds usual_patience{3000};

/// A number in the fewest digits that a float, or a double, needs.
std::string short_number(double x) {
  const auto narrow = static_cast<float>(x);
  return static_cast<double>(narrow) == x ? fmt::format("{}", narrow) : fmt::format("{}", x);
}

std::string short_list(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  for (const double x : numbers) texts.push_back(short_number(x));
  return numbers.size() == 1 ? texts.front() : fmt::format("({})", fmt::join(texts, ", "));
}

/// Whether the oracle's answer to the case says the same of hit and miss as the calculation does of the
/// numbers that the library was given, which may have been rounded on the way there.
bool agrees_with_oracle(const Dossier& dossier) {
  const Answer& exact = dossier.recorded.finding.evidence.exact;
  if (const auto* position = std::get_if<Position>(&exact))
    return (*position == Position::boundary) == dossier.right.is_on_boundary &&
           (*position == Position::inside) == (dossier.right.is_inside && !dossier.right.is_on_boundary);
  return (std::get<RayAnswer>(exact).hits.count > 0) == dossier.right.is_hit();
}

std::string objection_to(const Dossier& dossier) {
  if (!agrees_with_oracle(dossier))
    return "by hand the numbers that the library was given come to another answer than the case: they were "
           "rounded on the way";
  if (!dossier.comparison.is_wrong)
    return "on this case the library is right, within rounding; what breaks is a case made from it";
  return "";
}

std::string got_of(const Reproduction& reproduction) {
  return reproduction.has_returned ? "`" + reproduction.printed + "`"
                                   : fmt::format("no answer, the program {}", reproduction.ending);
}

}  // namespace

std::string numbers_in_words(const NamedNumbers& inputs) {
  std::vector<std::string> texts;
  for (const auto& [name, numbers] : inputs)
    if (!numbers.empty() && name != "ring" && name != "corners" &&
        !(numbers.size() == 1 && std::isnan(numbers[0])))
      texts.push_back(fmt::format("{} = {}", name, short_list(numbers)));
  return fmt::format("{}", fmt::join(texts, ", "));
}

Dossier open_dossier(RecordedFinding recorded, const std::string& command) {
  Dossier dossier{.recorded = std::move(recorded)};
  dossier.library = facts_of(command);
  const Case& one = dossier.recorded.finding.one;
  dossier.reproduction = reproduction_of(command, one, usual_patience);
  dossier.right = by_hand(dossier.recorded.shape, dossier.reproduction.inputs);
  dossier.comparison = compare(dossier.right, dossier.reproduction, dossier.recorded.shape, one.precision);
  dossier.objection = objection_to(dossier);
  const Finding& finding = dossier.recorded.finding;
  for (const auto& [fault, sentence] : dossier.library.documented)
    if ((std::string(finding.property->name) + ": " + finding.diagnosis).find(fault) != std::string::npos)
      dossier.documentation = sentence;
  return dossier;
}

std::string bug_report(const Dossier& dossier) {
  const Reproduction& reproduction = dossier.reproduction;
  const Finding& finding = dossier.recorded.finding;
  const bool is_javascript = dossier.library.is_javascript();
  std::string steps;
  for (const std::string& step : dossier.right.steps) steps += "- " + step + "\n";
  std::string text = fmt::format(
      "# {}\n\n{} {}, `{}`.\n\n- Asked: {}\n- Expected: {}\n- Got: {}\n\n## Why, by hand\n\n{}\n"
      "## Reproduction\n\n`reproduction.{}`:\n\n```{}\n{}```\n\n```\n$ {}\n{}\n```\n",
      dossier.title(), dossier.library.name, dossier.library.version, reproduction.function,
      numbers_in_words(reproduction.inputs), dossier.comparison.expected, got_of(reproduction), steps,
      is_javascript ? "js" : "cpp", is_javascript ? "js" : "cpp", reproduction.source, dossier.library.build,
      reproduction.has_returned ? reproduction.printed : reproduction.ending);
  if (!finding.diagnosis.empty())
    text += fmt::format("\n## What cures it\n\nOf random cases, about {} failed alike: {}.\n", finding.cases,
                        finding.diagnosis);
  if (!dossier.documentation.empty()) text += "\nThe documentation: " + dossier.documentation + "\n";
  return text + "\n";
}

}  // namespace rayproof::dossier
