#pragma once
/// \file
/// A step of a stage's page, as it stands there without script and on paper.

#include <cstddef>
#include <string>

#include "viz/page/page.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Title, picture, words, typeset equations, what became of the digits, and a table of the numbers.
[[nodiscard]] std::string step_section(const Stage& stage, std::size_t number, const Still& still);

}  // namespace rayproof::viz
