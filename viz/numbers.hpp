#pragma once
/// \file
/// Numbers as a person reads them.

#include <string>

#include "case/case.hpp"
#include "viz/shadow.hpp"

namespace rayproof::viz {

/// The shortest decimal that reads back as the same number of the precision; "∞", "−∞", "NaN".
[[nodiscard]] std::string shown(double value, Precision precision);
/// Up to `digits` significant digits.
[[nodiscard]] std::string rough(double value, int digits = 3);
[[nodiscard]] std::string rough(const Shadow& value, int digits = 3);
/// A subscript: ₀, ₁, …
[[nodiscard]] std::string subscript(std::size_t index);
/// How many numbers of the precision lie from `a` to `b`, as a sentence reads it: "equal", "1 ulp", "3e7
/// ulps".
[[nodiscard]] std::string ulps_apart(double a, double b, Precision precision);

}  // namespace rayproof::viz
