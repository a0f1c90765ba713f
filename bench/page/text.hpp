#pragma once
#include <string>

#include "bench/page/conclusions.hpp"

namespace rayproof::report {

/// What the terminal shows: a table for each shape and precision, the headline, which method to take, and
/// what became of an older report's figures.
[[nodiscard]] std::string to_text(const Conclusions& found);

/// A figure in a table: "0.55", "1.2e+04", "inf", and a dash where there is none.
[[nodiscard]] std::string figure(double x);
/// A time of a curve: "0.55", "12.3", "12000".
[[nodiscard]] std::string nanoseconds(double ns);

}  // namespace rayproof::report
