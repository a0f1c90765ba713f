#pragma once
/// \file
/// Variations of a case: a few of its numbers changed a little or a lot.

#include <optional>

#include "case/case.hpp"
#include "generators/random.hpp"

namespace rayproof::worst {

/// A case of the same form with one to a few numbers changed: a bit, a few ulps, the exponent, the sign, few
/// digits, another number's value, a vector scaled or moved along another one, or a number of `mate`. Its
/// numbers are rounded to the precision. Nothing where the case format would refuse it.
[[nodiscard]] std::optional<Case> varied(const Case& one, const Case& mate, Random& random);

/// `to`, moved on by the share of the way from `from` to it. Nothing where the two are not of one form, or
/// the case format would refuse the result.
[[nodiscard]] std::optional<Case> moved_on(const Case& from, const Case& to, double share);

}  // namespace rayproof::worst
