#pragma once
/// \file
/// The oracle's numbers, exact and filtering, read as doubles or as numbers of any size.

#include <cmath>
#include <optional>
#include <utility>

#include "oracle/numbers/double_double.hpp"
#include "oracle/numbers/exact.hpp"
#include "oracle/numbers/interval.hpp"

namespace rayproof::oracle {

/// Numbers to read values by: doubles for the filters, which are used only where doubles do not overflow.
[[nodiscard]] inline double read(const Interval& x) { return x.middle; }
[[nodiscard]] inline double read(const Ball& x) { return x.high; }
[[nodiscard]] inline double read(const Pair& x) { return x.high; }
[[nodiscard]] inline Scaled read(const Ring& x) { return approximate(x); }
[[nodiscard]] inline Scaled read(const Scaled& x) { return x; }

template <class R>
using NumberOf = decltype(read(std::declval<R>()));

/// How far the true value of `x` may lie from read(x).
[[nodiscard]] inline double uncertainty(const Interval& x) { return x.radius; }
[[nodiscard]] inline double uncertainty(const Ball& x) { return x.radius; }
[[nodiscard]] inline double uncertainty(const Pair&) { return 0; }
[[nodiscard]] inline double uncertainty(const Ring&) { return 0; }

[[nodiscard]] inline std::optional<int> certain_sign(const Ring& x) { return sign(x); }
/// The sign of an interval or a ball that does not touch 0; otherwise nothing.
template <class Filter>
[[nodiscard]] std::optional<int> certain_sign(const Filter& x) {
  if (std::abs(read(x)) > 1.001 * x.radius) return read(x) > 0 ? 1 : -1;
  return std::nullopt;
}

/// What was read as a double.
[[nodiscard]] inline double value(double x) { return x; }
[[nodiscard]] inline double value(const Scaled& x) { return static_cast<double>(x.value()); }

}  // namespace rayproof::oracle
