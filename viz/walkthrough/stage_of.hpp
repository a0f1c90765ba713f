#pragma once
/// \file
/// From a case report to its stage.

#include "viz/explain/case_report.hpp"
#include "viz/scene/stage.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// The stage of a case, its exact answer, and a method's answer and run, where there is a method. Any valid
/// case has one: without a method, or with one that can't be recorded, it has the first and the last step.
[[nodiscard]] Stage stage_of(const CaseReport& report);

/// Lets every near step see a little more where a step's items reach beyond the shape's own view: the same
/// for all of them, so that nothing jumps.
void widen_views(Stage& stage, const Setting& setting);

}  // namespace rayproof::viz
