#include "viz/walkthrough/lesson.hpp"

#include <algorithm>

#include "case/reader.hpp"
#include "viz/walkthrough/beside.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lessons.hpp"
#include "viz/walkthrough/stage_of.hpp"

namespace rayproof::viz {

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> all = [] {
    std::vector<Lesson> list;
    for (const auto group : lesson_groups)
      for (Lesson& lesson : group()) list.push_back(std::move(lesson));
    // Groups together, in the order in which they first appear.
    std::vector<std::string> groups;
    for (const Lesson& lesson : list) {
      if (std::find(groups.begin(), groups.end(), lesson.group) == groups.end())
        groups.push_back(lesson.group);
    }
    const auto rank = [&](const Lesson& lesson) {
      return std::find(groups.begin(), groups.end(), lesson.group);
    };
    std::stable_sort(list.begin(), list.end(),
                     [&](const Lesson& a, const Lesson& b) { return rank(a) < rank(b); });
    return list;
  }();
  return all;
}

std::vector<const Lesson*> lessons_of(std::string_view topic) {
  std::vector<const Lesson*> found;
  for (const Lesson& lesson : lessons()) {
    if (lesson.name == topic) return {&lesson};
    if (topic == "all" || lesson.group == topic) found.push_back(&lesson);
  }
  return found;
}

Stage stage_of(const Lesson& lesson, const ReportCase& report_on) {
  const Case one = read_case(lesson.case_text);
  Stage stage = lesson.compose != nullptr ? lesson.compose(one, report_on)
                : lesson.beside.empty()   ? stage_of(report_on(one, lesson.method))
                                          : stage_beside(one, report_on, lesson.method, lesson.beside);
  for (const auto& [title, words] : lesson.notes) {
    StageStep& step = stage.steps.at(place_of(stage.steps, title));
    const std::size_t end = step.caption.starts_with(step.words) ? step.words.size() : step.caption.size();
    const std::string space = end == 0 ? "" : " ";
    step.caption.insert(end, space + words + (end == 0 && !step.caption.empty() ? " " : ""));
    step.words += (step.words.empty() ? "" : " ") + std::string(words);
  }
  stage.name = lesson.name;
  stage.title = lesson.title;
  stage.sentence = lesson.sentence;
  return stage;
}

}  // namespace rayproof::viz
