#include "viz/stage/lesson.hpp"

#include "case/reader.hpp"
#include "viz/stage/lessons.hpp"
#include "viz/stage/stage_of.hpp"

namespace rayproof::viz {

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> all = [] {
    std::vector<Lesson> list;
    for (const auto& group : {ray_lessons(), plane_lessons(), triangle_lessons(), polygon_lessons(),
                              quadratic_lessons(), sphere_lessons(), solid_lessons()})
      list.insert(list.end(), group.begin(), group.end());
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

Stage stage_of(const Lesson& lesson, const TellCase& tell) {
  const Case one = read_case(lesson.case_text);
  Stage stage = lesson.compose != nullptr ? lesson.compose(one, tell) : stage_of(tell(one, lesson.method));
  stage.name = lesson.name;
  stage.title = lesson.title;
  stage.sentence = lesson.sentence;
  return stage;
}

}  // namespace rayproof::viz
