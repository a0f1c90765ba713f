#include "viz/programs/walk/walks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/print_to_stderr.hpp"
#include "case/reader/near_names.hpp"
#include "viz/programs/report_of.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/stage_of.hpp"

namespace rayproof::viz {
namespace {

/// The report on the case with its method; without one, or its answer, by the first sound one of its topic
/// whose steps can be recorded.
CaseReport report_for(const CaseOptions& options) {
  const CaseReport report = report_case(options);
  if (report.claimed) return report;
  for (const Subject& subject : subjects()) {
    if (subject.topic != topic_of(report.one) || subject.contract.standing != Standing::sound) continue;
    if (!recorded_walk(report.one, subject.name)) continue;
    print_to_stderr(
        "rayproof walk: {} (the first sound method whose steps can be recorded; --method chooses)\n",
        subject.full_name());
    return report_of(report.one, &subject);
  }
  print_to_stderr(
      "rayproof walk: the exact answer alone (no {} method's steps can be recorded; --method chooses)\n",
      topic_of(report.one));
  return report;
}

/// Why a topic has no lessons.
std::string no_topic(const std::string& topic) {
  std::vector<std::string> names;
  for (const Lesson& lesson : lessons()) {
    names.push_back(lesson.name);
    if (std::ranges::find(names, lesson.group) == names.end()) names.push_back(lesson.group);
  }
  const auto meant = likely_name(topic, names);
  return fmt::format("there is no topic '{}'; {}", topic,
                     meant ? fmt::format("did you mean {}?", *meant) : "rayproof walk --list names them");
}

}  // namespace

std::vector<Walk> walks_for(const std::string& topic, const CaseOptions& one, ProgressLine& progress) {
  if (!one.text.empty()) return {{"Cases", stage_of(report_for(one))}};
  const auto found = lessons_of(topic);
  if (topic.empty()) throw WrongCommand("which walkthrough? Give a topic, --case or --list");
  if (found.empty()) throw WrongCommand(no_topic(topic));
  std::vector<Walk> walks;
  for (const Lesson* lesson : found) {
    progress.show(share(walks.size(), found.size()), lesson->name + " is computed");
    walks.push_back({lesson->group, stage_of(*lesson, [](const Case& asked, const std::string& method) {
                       return report_of(asked, method);
                     })});
  }
  return walks;
}

}  // namespace rayproof::viz
