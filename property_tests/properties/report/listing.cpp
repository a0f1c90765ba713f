#include "properties/report/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>

#include "case/findings_file.hpp"
#include "case/writer.hpp"
#include "properties/engine/kind.hpp"

namespace rayproof {

namespace {

/// "41-46  sphere/textbook, half_b", or "41  sphere/textbook", and what the first of them does wrong.
std::string line_of(const std::vector<Finding>& group) {
  const Finding& first = group.front();
  const auto [least, most] = std::ranges::minmax(group, {}, &Finding::number);
  std::string numbers = std::to_string(least.number);
  if (group.size() > 1) numbers += fmt::format("-{}", most.number);
  std::string methods = first.subject->full_name();
  std::vector<const Subject*> seen{first.subject};
  for (const Finding& finding : group) {
    if (std::ranges::find(seen, finding.subject) != seen.end()) continue;
    seen.push_back(finding.subject);
    methods += ", " + finding.subject->name;
  }
  return fmt::format("{:>5}  {} {}  {}\n", numbers, methods, name_of(first.one.precision), in_words(first));
}

/// "gross: t is right divided by …": the worst of the findings of a group, or that of most cases. Nothing
/// where none is diagnosed.
std::string diagnosis_of(const std::vector<Finding>& group) {
  const auto by_weight = [](const Finding& one) {
    return std::tuple(one.diagnosis.empty(), one.cause == nullptr, kind_of(one), ~one.cases);
  };
  const Finding& worst = *std::ranges::min_element(group, {}, by_weight);
  if (worst.diagnosis.empty()) return "";
  return fmt::format("       {}: {}\n", name_of(kind_of(worst)), worst.diagnosis);
}

}  // namespace

std::string text_finding(const Finding& finding) { return line_of({finding}); }

std::string text_declared(const std::vector<Finding>& findings) {
  std::string text;
  for (const std::vector<Finding>& group : alike(findings, true))
    text += line_of(group);  // the contract says why; the page and the file have the diagnosis
  return text;
}

std::string text_failures(const std::vector<Finding>& findings) {
  std::string text;
  for (const std::vector<Finding>& group : alike(findings, false)) {
    const Finding& first = group.front();
    const bool says_it_all = first.property->claim == Claim::answers;  // the first line does
    text += fmt::format("{}{}       breaks '{}': {}\n       family {}{}\n       {}\n", line_of(group),
                        diagnosis_of(group), first.property->name, first.property->statement, first.family,
                        says_it_all ? "" : "; " + first.evidence.note, write_case(first.one));
  }
  return text;
}

std::string from_option(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "findings.jsonl";
  if (file.lexically_normal() == last_findings) return "";
  std::string quoted;
  for (const char letter : file.string()) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  const bool is_plain = std::ranges::all_of(quoted, [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '/' || letter == '.' || letter == '_' || letter == '-';
  });
  return " --from " + (is_plain ? quoted : "'" + quoted + "'");
}

}  // namespace rayproof
