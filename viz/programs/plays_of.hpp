#pragma once
/// \file
/// Walkthroughs that can be made again of another case, asked of the oracle and the method each time.

#include <string>
#include <vector>

#include "case/writer.hpp"
#include "viz/player/player.hpp"
#include "viz/programs/report_of.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {

/// The lessons of a topic; again with the lesson's method.
[[nodiscard]] inline std::vector<Play> plays_of(const std::string& topic) {
  const ReportCase report_on = [](const Case& one, const std::string& method) {
    return report_of(one, method);
  };
  std::vector<Play> plays;
  for (const Lesson* lesson : lessons_of(topic)) {
    const auto again = [lesson, report_on](const Case& one) {
      Lesson changed = *lesson;
      changed.case_text = write_case(one);
      return stage_of(changed, report_on);
    };
    plays.push_back({stage_of(*lesson, report_on), again});
  }
  return plays;
}

/// The stage of any case; again with the same method.
[[nodiscard]] inline std::vector<Play> plays_of(const Stage& stage) {
  const auto again = [method = stage.method](const Case& one) { return stage_of(report_of(one, method)); };
  return {{stage, again}};
}

}  // namespace rayproof::viz
