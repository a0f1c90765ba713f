#include "viz/walkthrough/lesson.hpp"

#include <algorithm>

#include "case/reader.hpp"
#include "case/reader/field.hpp"
#include "viz/walkthrough/compose.hpp"

namespace rayproof::viz {
namespace {

Lesson read_lesson(const Field& field) {
  ObjectReader reader(field);
  const auto text_of = [&](const char* name) {
    const auto given = reader.find(name);
    return given ? read_string(*given) : std::string();
  };
  Lesson lesson{.name = text_of("name"),
                .group = text_of("group"),
                .title = text_of("title"),
                .sentence = text_of("sentence"),
                .case_text = std::string(reader.need("case").node().text),
                .method = text_of("method"),
                .beside = text_of("beside"),
                .first = text_of("first"),
                .runs = text_of("runs"),
                .source = text_of("source"),
                .conclusion = text_of("conclusion")};
  if (const auto notes = reader.find("notes")) {
    for (const Field& note : notes->elements("must be a list of notes")) {
      const std::vector<Field> parts = note.elements("must be a step's title and words", 2);
      lesson.notes.push_back({read_string(parts[0]), read_string(parts[1])});
    }
  }
  reader.refuse_unknown();
  const auto* const own = std::ranges::find(composers, lesson.name, &Composer::lesson);
  if (own != composers.end()) lesson.compose = own->compose;
  return lesson;
}

}  // namespace

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> all = [] {
    const json::Document document = json::parse(lessons_text);
    std::vector<Lesson> list;
    for (const Field& field : Field{.document = &document}.elements("must be a list of lessons"))
      list.push_back(read_lesson(field));
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
  const auto say = [](std::string& place, const std::string& words) {
    if (!words.empty()) place = words;
  };
  say(stage.steps.front().title, lesson.first);
  say(stage.method, lesson.runs);
  say(stage.source, lesson.source);
  say(stage.conclusion, lesson.conclusion);
  for (const auto& [title, words] : lesson.notes) {
    StageStep& step = stage.steps.at(place_of(stage.steps, title));
    const std::size_t end = step.caption.starts_with(step.words) ? step.words.size() : step.caption.size();
    const std::string space = end == 0 ? "" : " ";
    step.caption.insert(end, space + words + (end == 0 && !step.caption.empty() ? " " : ""));
    step.words += (step.words.empty() ? "" : " ") + words;
  }
  stage.name = lesson.name;
  stage.title = lesson.title;
  stage.sentence = lesson.sentence;
  return stage;
}

}  // namespace rayproof::viz
