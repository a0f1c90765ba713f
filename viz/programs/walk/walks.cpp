#include "viz/programs/walk/walks.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "viz/programs/told_of.hpp"
#include "viz/stage/lesson.hpp"
#include "viz/stage/stage_of.hpp"

namespace rayproof::viz {
namespace {

/// The case as told by its method; without one, by the first sound one of its topic whose steps can be
/// recorded.
Told told_for(const CaseOptions& options) {
  Told told = tell_case(options);
  if (!told.method.empty()) return told;
  const TopicView* const view = view_of(told.one);
  for (const Subject& subject : subjects()) {
    if (subject.topic != topic_of(told.one) || subject.contract.standing != Standing::sound) continue;
    if (view != nullptr) told.walk = view->walk(told.one, subject.name);
    if (!told.walk) continue;
    told.method = subject.full_name();
    told.claimed = subject.answer(told.one);
    fmt::print(stderr,
               "rayproof walk: {} (the first sound method whose steps can be recorded; --method chooses)\n",
               told.method);
    return told;
  }
  fmt::print(
      stderr,
      "rayproof walk: the exact answer alone (no {} method's steps can be recorded; --method chooses)\n",
      topic_of(told.one));
  return told;
}

}  // namespace

std::vector<Walk> walks_for(const std::string& topic, const CaseOptions& one, ProgressLine& progress) {
  if (!one.text.empty()) return {{"Cases", stage_of(told_for(one))}};
  const auto found = lessons_of(topic);
  if (topic.empty()) throw WrongCommand("which walkthrough? Give a topic, --case or --list");
  if (found.empty()) {
    throw WrongCommand(fmt::format("there is no topic '{}'; rayproof walk --list names them", topic));
  }
  std::vector<Walk> walks;
  for (const Lesson* lesson : found) {
    progress.show(share(walks.size(), found.size()), lesson->name + " is computed");
    walks.push_back({lesson->group, stage_of(*lesson, [](const Case& asked, const std::string& method) {
                       return told_of(asked, method);
                     })});
  }
  return walks;
}

}  // namespace rayproof::viz
