#pragma once
/// \file
/// Numbers as a person reads them.

#include <string>

#include "case/case.hpp"
#include "viz/trace/shadow.hpp"

namespace rayproof::viz {

/// The shortest decimal that reads back as the same number of the precision; "∞", "−∞", "NaN".
[[nodiscard]] std::string shown(double value, Precision precision);
[[nodiscard]] std::string shown(const glm::dvec3& v, Precision precision);
/// A number in real arithmetic, beside `value`, which is it rounded to a format of `bits` bits: float or
/// double. Where the two are equal, the shortest decimal that reads back as the same double. Else 12 digits
/// beside a float and 17 beside a double, or as many more as set them apart; final zeros stay, since 0.25
/// beside 0.25 would look equal.
[[nodiscard]] std::string exact_beside(const Shadow& exact, double value, int bits);
/// Up to `digits` significant digits.
[[nodiscard]] std::string rough(double value, int digits = 3);
[[nodiscard]] std::string rough(const Shadow& value, int digits = 3);
/// What a drawing at `times` the size of the thing says of itself: "Magnified ×20", "Reduced to 1/20".
[[nodiscard]] std::string scale_in_words(const Shadow& times);
[[nodiscard]] std::string subscript(std::size_t index);
/// How many numbers of the precision lie from `a` to `b`, 0 and -0 being one: counted in integers, and the
/// count rounded once to double (exact up to 2^53). Infinite where one is NaN, or where one of two different
/// numbers is infinite.
[[nodiscard]] double count_ulps(double a, double b, Precision precision);
/// "1 ulp", "639 ulps", "3.9e7 ulps".
[[nodiscard]] std::string in_ulps(double ulps);
/// Of an answer this many ulps from the correctly rounded one: "the exact one, correctly rounded", "off by
/// 639 ulps", "infinitely far off".
[[nodiscard]] std::string accuracy_in_words(double ulps);
/// The distance of a number from the exact one, `a`: "equal", "639 ulps", "infinitely far"; the difference
/// itself, "0.037", beyond a hundredth of `a`.
[[nodiscard]] std::string apart_in_words(double a, double b, Precision precision);

}  // namespace rayproof::viz
