#pragma once
/// \file
/// The answer to "which method do I take?": a table for the terminal, one for the page, and a plot.

#include <string>
#include <vector>

#include "bench/figures/choice.hpp"

namespace rayproof::report {

[[nodiscard]] std::string choices_in_text(const std::vector<Choice>& choices);
/// With what each method guarantees.
[[nodiscard]] std::string choices_in_html(const std::vector<Choice>& choices);
/// For scenes near by: what the fastest method of each shape and precision costs, and what the exact one
/// does. Empty where nothing near by was measured.
[[nodiscard]] std::string choices_in_svg(const std::vector<Choice>& choices);

}  // namespace rayproof::report
