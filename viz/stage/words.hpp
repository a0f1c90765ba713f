#pragma once
/// \file
/// What there is to see in a kernel's step, by the step's title.

#include <string>

namespace rayproof::viz {

/// One sentence, or nothing for a step that needs none.
[[nodiscard]] std::string words_for(const std::string& title);

}  // namespace rayproof::viz
