#pragma once
/// \file
/// The lessons: teaching cases with the method that shows them best.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viz/explain/case_report.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Answers a case by the oracle and by a method ("" for none): programs pass report_of
/// (viz/programs/report_of.hpp).
using ReportCase = std::function<CaseReport(const Case& one, const std::string& method)>;

/// What a lesson's own case has to say in a step, beside the kernel's words for every case.
struct LessonNote {
  std::string step;  ///< how the step's title begins
  std::string words;
};

/// A topic of `rayproof walk`: an entry of lessons/lessons.json.
struct Lesson {
  std::string name;      ///< "far-sphere"
  std::string group;     ///< "spheres": what `walk spheres` walks all of
  std::string title;     ///< "Why a far sphere breaks"
  std::string sentence;  ///< what there is to learn
  std::string case_text;
  std::string method{};
  /// Where the steps are not one method's run on the case alone; else left out.
  Stage (*compose)(const Case& one, const ReportCase& report_on) = nullptr;
  std::vector<LessonNote> notes{};
  std::string beside{};  ///< the right method, where `method` is one with a source's error
};

/// In the order of teaching, those of a group together.
[[nodiscard]] const std::vector<Lesson>& lessons();

/// The lessons of that name, or of that group, or all of them for "all"; none where there is no such topic.
[[nodiscard]] std::vector<const Lesson*> lessons_of(std::string_view topic);

/// The stage of a lesson, made from its own case.
[[nodiscard]] Stage stage_of(const Lesson& lesson, const ReportCase& report_on);

}  // namespace rayproof::viz
