#pragma once
/// \file
/// The names of formulas, typeset.

#include <string>

namespace rayproof::viz {

/// MathML of a name: its letters, then ".x" or "_x" or "₀" as a subscript, and an arrow above.
[[nodiscard]] std::string typeset_name(std::string text);

}  // namespace rayproof::viz
