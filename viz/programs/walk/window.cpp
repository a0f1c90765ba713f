#include "viz/programs/walk/window.hpp"

#include <stdexcept>

#include "case/writer.hpp"
#include "viz/programs/told_of.hpp"
#include "viz/stage/lesson.hpp"
#include "viz/stage/stage_of.hpp"
#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/stage_window.hpp"
#endif

namespace rayproof::viz {

std::vector<Play> plays_of(const std::string& topic) {
  const TellCase tell = [](const Case& one, const std::string& method) { return told_of(one, method); };
  std::vector<Play> plays;
  for (const Lesson* lesson : lessons_of(topic)) {
    const auto again = [lesson, tell](const Case& one) {
      Lesson changed = *lesson;
      changed.case_text = write_case(one);
      return stage_of(changed, tell);
    };
    plays.push_back({stage_of(*lesson, tell), again});
  }
  return plays;
}

std::vector<Play> plays_of(const Stage& stage) {
  const auto again = [method = stage.method](const Case& one) { return stage_of(told_of(one, method)); };
  return {{stage, again}};
}

void show_window(std::vector<Play> plays) {
#ifdef RAYPROOF_HAS_VTK
  require_display();
  Player player(std::move(plays));
  StageWindow window(player);
  window.run();
#else
  (void)plays;
  throw std::runtime_error("--window needs VTK, which this build was made without; --html works");
#endif
}

}  // namespace rayproof::viz
