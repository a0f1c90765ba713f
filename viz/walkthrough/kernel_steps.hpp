#pragma once
/// \file
/// A kernel's own step as a step of a stage: its named values become items by the topic's bindings.

#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {

/// Into how many parts step `index` of the walkthrough can be split, each of which draws one new thing.
[[nodiscard]] std::size_t count_parts(const CaseReport& report, const Walkthrough& walk, std::size_t index,
                                      const Setting& setting);

/// Step `index` of the walkthrough on the setting's stage, whole or in its parts.
[[nodiscard]] std::vector<StageStep> kernel_steps(const CaseReport& report, const Walkthrough& walk,
                                                  std::size_t index, const Setting& setting, bool is_split);

}  // namespace rayproof::viz
