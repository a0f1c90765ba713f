#pragma once
/// \file
/// A case in few views: what is asked, the truth, and what the code said.

#include "viz/explain/case_report.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// A stage without a slider, whose steps are the views: the shape with both answers' hits; all with the ray's
/// start, where that is much larger; and what differs, magnified, where it is too small to be seen.
[[nodiscard]] Stage case_views(const CaseReport& report);

}  // namespace rayproof::viz
