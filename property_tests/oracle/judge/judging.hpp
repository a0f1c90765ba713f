#pragma once
/// \file
/// What the judges of all questions have in common: the errors of claimed numbers against exact ones, in the
/// units of the contracts.

#include <algorithm>
#include <cmath>
#include <vector>

#include "case/each_number.hpp"
#include "oracle/geometry/intersection.hpp"
#include "oracle/numbers/ulp.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::oracle {

/// Judges claimed hits against the exact ones.
[[nodiscard]] Judgement judge(const ExactIntersection& exact, Precision precision, const RayAnswer& claimed);

/// Judges what they say of their first hit beside t.
[[nodiscard]] Details judge_details(const ExactIntersection& exact, Precision precision,
                                    const RayAnswer& claimed);

/// The finite ends of the ray's interval.
[[nodiscard]] std::vector<double> finite_ends(const Ray<double>& ray);

/// A measure in units of ε.
[[nodiscard]] inline double in_units(const Scaled& measure, Precision precision) {
  return value(measure / Scaled(unit_roundoff(precision)));
}

/// Whether `claimed` has another count of hits than the exact one, as far as it speaks of that.
[[nodiscard]] inline bool is_wrong_count(std::size_t exact, const RayAnswer& claimed) {
  if (claimed.verdict_only) return (claimed.hits.count > 0) != (exact > 0);
  return claimed.hits.count != (claimed.nearest_only ? std::min<std::size_t>(exact, 1) : exact);
}

/// The error of x in ulps of the exact number; an infinite or NaN x is right only where the exact number
/// rounds to the same infinity.
template <class Number>
[[nodiscard]] double error_in_ulps(const Number& exact, double x, Precision precision) {
  const double nearest = round_correctly(exact, precision);
  if (!std::isfinite(x) || !std::isfinite(nearest)) return x == nearest ? 0 : HUGE_VAL;
  return value(abs(exact.minus(x)) / Scaled(ulp_of(nearest, precision)));
}

/// Notes the worst of the claimed numbers' errors: x is off by `ulps`, and residual() is what it leaves, in
/// units. No residual can be asked of an x that is as good as the nearest number where the grid of floats
/// itself is coarse or ends.
template <class Residual>
void note_error(Judgement& judgement, Precision precision, double x, double ulps, const Residual& residual) {
  if (!judgement.wrong) judgement.ulp = std::max(judgement.ulp, ulps);
  const double smallest_normal = precision == Precision::float32 ? 0x1p-126 : 0x1p-1022;
  if (ulps <= 1 && (!std::isfinite(x) || std::abs(x) < smallest_normal)) return;
  judgement.residual = std::max(judgement.residual, std::isfinite(x) ? residual() : HUGE_VAL);
}

/// Notes log2 of the smallest and largest nonzero magnitude among the numbers of `values`.
template <class... Values>
void note_range(Judgement& judgement, const Values&... values) {
  double smallest = HUGE_VAL, largest = 0;
  const auto note = [&](double x) {
    if (x == 0) return;
    smallest = std::min(smallest, std::abs(x));
    largest = std::max(largest, std::abs(x));
  };
  (each_number(values, note), ...);
  judgement.smallest = std::logb(smallest);
  judgement.largest = std::logb(largest);
}

/// The smaller of two.
inline void reduce(Scaled& smallest, const Scaled& x) {
  if (x < smallest) smallest = x;
}

/// More than any margin that matters.
[[nodiscard]] inline Scaled endless() { return {1, 1L << 40}; }

}  // namespace rayproof::oracle
