#pragma once
/// \file
/// Formulas, typeset by the browser.

#include <string>

#include "viz/trace/expression.hpp"

namespace rayproof::viz {

/// A `<math>` element: quotients are fractions, "t₀" and "S_x" get subscripts.
[[nodiscard]] std::string math_ml(const Formula& formula);

}  // namespace rayproof::viz
