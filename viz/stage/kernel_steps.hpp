#pragma once
/// \file
/// A kernel's own step as a step of a stage: its named values become items by the topic's bindings.

#include "viz/stage/setting.hpp"

namespace rayproof::viz {

/// Values named name.x, name.y, name.z together, in the order of naming.
[[nodiscard]] std::vector<StageValue> grouped(const std::vector<WalkValue>& values);

/// The rounded number as the shortest decimal that reads back as it; a vector's in parentheses.
[[nodiscard]] std::string shown(const StageValue& value, Precision precision);

/// "D = b·b − 4·a·c = 3·3 − 4·1·2 = 1"
[[nodiscard]] std::string equation_of(const StageValue& value, Precision precision);

/// Into how many parts step `index` of the walkthrough can be split, each of which draws one new thing.
[[nodiscard]] std::size_t count_parts(const Told& told, const Walkthrough& walk, std::size_t index,
                                      const Setting& setting);

/// Step `index` of the walkthrough on the setting's stage, whole or in its parts.
[[nodiscard]] std::vector<StageStep> kernel_steps(const Told& told, const Walkthrough& walk,
                                                  std::size_t index, const Setting& setting, bool is_split);

}  // namespace rayproof::viz
