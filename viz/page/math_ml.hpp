#pragma once
/// \file
/// Formulas, as the narration writes them in plain Unicode, typeset by the browser.

#include <string>
#include <vector>

namespace rayproof::viz {

/// A `<math>` element: "(−b − √D) / (2·a)" becomes a fraction with a root in it, "t₀" and "S_x" get
/// subscripts, "d⃗" an arrow. Text that is no formula comes back as it stands, escaped.
[[nodiscard]] std::string math_ml(const std::string& formula);

/// The terms of a sum, each with the sign before it: "b·b − 4·(a + c)" is "b·b" and "− 4·(a + c)".
[[nodiscard]] std::vector<std::string> terms_of(const std::string& formula);

}  // namespace rayproof::viz
