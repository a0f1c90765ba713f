#include "properties/report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "case/writer.hpp"
#include "properties/report/order.hpp"
#include "properties/report/words.hpp"

namespace rayproof {

namespace {

/// "41-46", or "41".
std::string numbers_of(const std::vector<Finding>& group) {
  const std::string first = std::to_string(group.front().number);
  return group.size() == 1 ? first : fmt::format("{}-{}", first, group.back().number);
}

/// "sphere/textbook, half_b".
std::string methods_of(const std::vector<Finding>& group) {
  std::string methods;
  std::vector<const Subject*> seen;
  for (const Finding& finding : group) {
    if (std::find(seen.begin(), seen.end(), finding.subject) != seen.end()) continue;
    seen.push_back(finding.subject);
    methods += methods.empty() ? finding.subject->full_name() : ", " + finding.subject->name;
  }
  return methods;
}

std::string line_of(const std::string& numbers, const std::string& methods, const Finding& finding) {
  return fmt::format("{:>5}  {} {}  {}\n", numbers, methods, name_of(finding.one.precision),
                     in_words(finding));
}

}  // namespace

std::string text_declared(const RunResult& result) {
  std::string text;
  for (const std::vector<Finding>& group : alike(result.findings, true))
    text += line_of(numbers_of(group), methods_of(group), group.front());
  return text;
}

std::string text_failures(const RunResult& result) {
  std::string text;
  for (const std::vector<Finding>& group : alike(result.findings, false)) {
    const Finding& first = group.front();
    text += line_of(numbers_of(group), methods_of(group), first);
    text += fmt::format("       breaks '{}': {}\n       family {}; {}\n       {}\n", first.property->name,
                        first.property->statement, first.family, first.evidence.note, write_case(first.one));
  }
  return text;
}

std::string text_finding(const Finding& finding) {
  return line_of(std::to_string(finding.number), finding.subject->full_name(), finding);
}

}  // namespace rayproof
