#pragma once
/// \file
/// What the walkthroughs of surfaces that are no shape of the cases have in common.

#include <string_view>

#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// The surface and the ray up to t_end, with a slider over the same.
[[nodiscard]] Setting surface_setting(const CaseReport& report, Items surface, double t_end);

/// From the steps of that title on, what was drawn before is shown no more.
void begin_anew(Stage& stage, std::string_view title);

}  // namespace rayproof::viz
