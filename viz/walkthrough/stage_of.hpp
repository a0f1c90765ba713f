#pragma once
/// \file
/// Stages: of a case report, of a case in few views, and of a formula as a source prints it beside the right
/// one.

#include "viz/explain/case_report.hpp"
#include "viz/scene/stage.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

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

/// Into how many parts step `index` of the walkthrough can be split, each of which draws one new thing.
[[nodiscard]] std::size_t count_parts(const CaseReport& report, const Walkthrough& walk, std::size_t index,
                                      const Setting& setting);

/// Step `index` of the walkthrough on the setting's stage, whole or in its parts.
[[nodiscard]] std::vector<StageStep> kernel_steps(const CaseReport& report, const Walkthrough& walk,
                                                  std::size_t index, const Setting& setting, bool is_split);

}  // namespace rayproof::viz
