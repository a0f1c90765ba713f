#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "dossier/collection.hpp"

namespace rayproof::dossier {
namespace {

/// A cell of a table: no bar, no line break.
std::string cell(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, "\\");
  return text;
}

std::string row(const char* name, const std::string& text) {
  return text.empty() ? "" : fmt::format("| {} | {} |\n", name, cell(text));
}

std::string judged_table(const LibraryDossier& library) {
  std::string text =
      "| subject | shape | answered | excluded | judged, on how many cases | findings |\n| --- | --- | --- | "
      "--- | --- | --- |\n";
  for (const JudgedShape& one : library.judged) {
    std::vector<std::string> claims;
    std::vector<std::size_t> found;
    for (const auto& [claim, count] : one.claims) claims.push_back(fmt::format("{} {}", claim, count));
    for (const FiledFinding& filed : library.findings)
      if (filed.is_of(one)) found.push_back(filed.recorded().finding.number);
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", one.name, one.shape, one.answered(),
                        one.unsupported, fmt::join(claims, ", "),
                        found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", ")));
  }
  return text + "\n";
}

std::string finding_in_markdown(const FiledFinding& filed) {
  const RecordedFinding& recorded = filed.recorded();
  const Finding& finding = recorded.finding;
  const Dossier& dossier = filed.dossier;
  const bool is_confirmed = filed.trouble.empty() && dossier.objection.empty();
  std::string text = fmt::format(
      "### {}. {} (`{}`)\n\n![The case of finding {}](images/findings/{}.svg)\n\n| | |\n| --- | --- |\n",
      finding.number,
      is_confirmed ? dossier.title() : recorded.shape + "/" + recorded.name + " " + recorded.says,
      recorded.name, finding.number, finding.number);
  text += row("kind", fmt::format("{}, {}", recorded.kind, where_seen(finding))) +
          row("found", recorded.says) + row("also in", also_in_words(filed));
  if (filed.trouble.empty())
    text += row("asked", "`" + numbers_in_words(dossier.reproduction.inputs) + "`") +
            row("it said", dossier.reproduction.has_returned ? "`" + dossier.reproduction.printed + "`"
                                                             : "no answer: " + dossier.reproduction.ending) +
            row("right is", dossier.comparison.expected) +
            row("by hand", fmt::format("{}", fmt::join(dossier.right.steps, " ")));
  text += row("diagnosis", finding.diagnosis.empty() ? "none: there is no answer" : finding.diagnosis) +
          row("documentation", documentation_of(filed)) + row("not to be filed", dossier.objection) +
          row("not asked again", filed.trouble);
  return text + "\n";
}

}  // namespace

std::string findings_markdown(const std::vector<LibraryDossier>& libraries, const std::string& command) {
  std::string text = fmt::format(
      "# Findings in other people's libraries\n\nThis page is written by a command, here of checks with "
      "{}:\n\n```\n{}\n```\n\n"
      "What a library's documentation excludes is counted and not judged ([peers.md](peers.md)). A finding "
      "is a smallest case, asked again of the\n"
      "library, with what is right computed by hand's formula in exact fractions. What has the same "
      "diagnosis in\n"
      "other shapes is the same fault, and stands under *also in*. *found* and the picture count t in "
      "lengths "
      "of the case's own direction;\n"
      "*asked*, *it said*, *right is* and *by hand* in what the library counts: lengths of a unit direction, "
      "shares of a segment, or a depth.\n"
      "`rayproof bugreport N --from docs/findings.jsonl` makes a report of finding N. Kinds and claims: "
      "[reading-a-check.md](reading-a-check.md), "
      "[your-own-code.md](your-own-code.md#how-to-read-the-result).\n\n",
      budget_in_words(libraries), command);
  for (const LibraryDossier& library : libraries) {
    text += fmt::format("## {} {}\n\n{}", library.facts.name, library.facts.version, judged_table(library));
    if (library.findings.empty()) text += "A clean bill: nothing that was judged is wrong.\n\n";
    for (const FiledFinding& filed : library.findings) text += finding_in_markdown(filed);
  }
  return text;
}

}  // namespace rayproof::dossier
