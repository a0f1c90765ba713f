#pragma once
/// \file
/// Stages: of a case report, of a case in few views, of a formula as a source prints it beside the right one;
/// and the lessons, teaching cases with the method that shows them best.

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "viz/explain/case_report.hpp"
#include "viz/scene/stage.hpp"
#include "viz/walkthrough/setting.hpp"

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
  /// What a composed stage says of itself: the title of its first step, what ran, its source, its conclusion;
  /// empty where the composer says it, or the report.
  std::string first{}, runs{}, source{}, conclusion{};
};

/// In the order of teaching, those of a group together.
[[nodiscard]] const std::vector<Lesson>& lessons();

/// The lessons of that name, or of that group, or all of them for "all"; none where there is no such topic.
[[nodiscard]] std::vector<const Lesson*> lessons_of(std::string_view topic);
[[nodiscard]] Stage stage_of(const Lesson& lesson, const ReportCase& report_on);

/// lessons/lessons.json, put into the program when it is configured.
extern const char* const lessons_text;

using Compose = Stage(const Case& one, const ReportCase& report_on);

// Each in lessons/ or lessons/numbers/.
Compose ray_stage, camera_stage, loop_stage;
Compose barycentric_stage, parity_stage, printed_stage, polygon_stage, segment_stage;
Compose digits_stage, leak_stage, leaving_stage, acne_stage, map_stage, test_stage;
Compose intervals_stage, transformed_stage, normal_stage, torus_stage, patch_stage;

struct Composer {
  std::string_view lesson;
  Compose* compose;
};
inline constexpr std::array composers{
    Composer{"ray", ray_stage},
    Composer{"camera", camera_stage},
    Composer{"raycasting", loop_stage},
    Composer{"barycentric", barycentric_stage},
    Composer{"polygon-parity", parity_stage},
    Composer{"polygon-vertex-trap", printed_stage},
    Composer{"polygon-vertex-mended", parity_stage},
    Composer{"polygon-horizontal-trap", printed_stage},
    Composer{"polygon-star", parity_stage},
    Composer{"polygon-in-space", polygon_stage},
    Composer{"ray-segment", segment_stage},
    Composer{"digits", digits_stage},
    Composer{"leak", leak_stage},
    Composer{"leaving-a-sphere", leaving_stage},
    Composer{"acne", acne_stage},
    Composer{"error-map", map_stage},
    Composer{"property-test", test_stage},
    Composer{"slab-intervals", intervals_stage},
    Composer{"transformed", transformed_stage},
    Composer{"transformed-normal", normal_stage},
    Composer{"implicit-torus", torus_stage},
    Composer{"parametric-patch", patch_stage},
};

/// The stage of a case, its exact answer, and a method's answer and run, where there is a method. Any valid
/// case has one: without a method, or with one that can't be recorded, it has the first and the last step.
[[nodiscard]] Stage stage_of(const CaseReport& report);

/// Lets every near step see a little more where a step's items reach beyond the shape's own view: the same
/// for all of them, so that nothing jumps.
void widen_views(Stage& stage, const Setting& setting);

/// The stage of a method on the case, with only those steps that differ from `right`'s, then the steps of
/// `right` that differ from its.
[[nodiscard]] Stage stage_beside(const Case& one, const ReportCase& report_on, const std::string& method,
                                 const std::string& right);

/// A stage without a slider, whose steps are the views: the shape with both answers' hits; all with the ray's
/// start, where that is much larger; and what differs, magnified, where it is too small to be seen.
[[nodiscard]] Stage case_views(const CaseReport& report);

/// Step `index` of the walkthrough on the setting's stage, whole or in parts, each of which draws one new
/// thing.
[[nodiscard]] std::vector<StageStep> kernel_steps(const CaseReport& report, const Walkthrough& walk,
                                                  std::size_t index, const Setting& setting, bool is_split);

}  // namespace rayproof::viz
