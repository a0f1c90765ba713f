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
/// What a drawing at `times` the size of the thing says of itself: "Magnified ×20", "Reduced to 1/20".
[[nodiscard]] std::string scale_in_words(const Shadow& times);
/// A subscript: ₀, ₁, …
[[nodiscard]] std::string subscript(std::size_t index);
/// How many numbers of the precision lie from `a` to `b`; infinite where one of two different numbers is not
/// finite.
[[nodiscard]] double count_ulps(double a, double b, Precision precision);
/// "off by 639 ulps", "infinitely far off".
[[nodiscard]] std::string off_by(double ulps);
/// The distance of two numbers: "equal", "639 ulps", "infinitely far".
[[nodiscard]] std::string apart_in_words(double a, double b, Precision precision);

}  // namespace rayproof::viz
