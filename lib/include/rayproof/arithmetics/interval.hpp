#pragma once
/// \file
/// Interval arithmetic: a number is every number between two ends, and what comes out holds every number that
/// the formula gives for any choice of what went in.
///
/// Source: R. E. Moore, "Interval Analysis", 1966; names and the empty interval after IEEE 1788-2015.

#include <algorithm>
#include <concepts>
#include <rayproof/arithmetics/interval_rounding.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The outcomes that a comparison of numbers out of two intervals can have. It is not a bool and turns into
/// none: a kernel that branches on one does not compile, one that uses `select` gets both branches.
struct IntervalMask {
  bool may_hold = false;
  bool may_fail = true;

  constexpr IntervalMask() = default;
  // A plain outcome is a certain one.
  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr IntervalMask(bool outcome) : may_hold(outcome), may_fail(!outcome) {}
  constexpr IntervalMask(bool hold, bool fail) : may_hold(hold), may_fail(fail) {}

  [[nodiscard]] constexpr bool holds_for_certain() const { return may_hold && !may_fail; }
  [[nodiscard]] constexpr bool fails_for_certain() const { return may_fail && !may_hold; }

  friend constexpr IntervalMask operator!(IntervalMask m) { return {m.may_fail, m.may_hold}; }
  friend constexpr IntervalMask operator&&(IntervalMask a, IntervalMask b) {
    return {a.may_hold && b.may_hold, a.may_fail || b.may_fail};
  }
  friend constexpr IntervalMask operator||(IntervalMask a, IntervalMask b) { return !(!a && !b); }
};

/// All real numbers x with lo <= x <= hi; an infinite end is a bound and no member. Both ends NaN is the
/// empty interval: what NaN becomes, and what a formula gives that has no value anywhere (1/0, √-1). Every
/// operation with it is empty, every comparison with it fails, as with NaN.
///
/// Contract: for numbers x in X and y in Y, x∘y is in X∘Y wherever x∘y exists, for all floats and all of
/// + - * / sqrt square. Of one operation each end is off by no more than one step to the next float, and by
/// none where the exact end is a float above 2^-950 (for `float`: anywhere) in magnitude.
template <std::floating_point T>
struct Interval : Comparable<Interval<T>> {
  using Plain = T;

  T lo{};
  T hi{};

  constexpr Interval() = default;
  /// The one number, or the two neighbours between which it lies; infinity as all that overflowed, NaN as
  /// nothing.
  template <HeldByDouble U>
  // NOLINTNEXTLINE(google-explicit-constructor): kernels mix plain numbers in, as formulas do
  constexpr Interval(U exact) : lo(static_cast<T>(exact)), hi(lo) {
    const auto back = static_cast<double>(lo);
    const auto wide = static_cast<double>(exact);
    if (back > wide || lo == infinity<T>) lo = outward::below(lo);
    if (back < wide || hi == -infinity<T>) hi = outward::above(hi);
  }
  [[nodiscard]] static constexpr Interval between(T lo, T hi) { return {lo, hi}; }
  [[nodiscard]] static constexpr Interval empty() { return between(not_a_number<T>, not_a_number<T>); }
  [[nodiscard]] static constexpr Interval whole() { return between(-infinity<T>, infinity<T>); }

  [[nodiscard]] constexpr bool is_empty() const { return !(lo <= hi); }
  [[nodiscard]] constexpr bool is_point() const { return lo == hi; }
  [[nodiscard]] constexpr bool is_bounded() const { return -infinity<T> < lo && hi < infinity<T>; }
  [[nodiscard]] constexpr bool contains(T x) const { return lo <= x && x <= hi; }
  [[nodiscard]] constexpr bool contains(const Interval& x) const { return lo <= x.lo && x.hi <= hi; }
  /// 1 or -1 where every number has that sign, 0 where all are 0; otherwise, and for the empty one, 2.
  [[nodiscard]] constexpr int sign_or_two() const {
    if (lo > 0) return 1;
    if (hi < 0) return -1;
    return lo == 0 && hi == 0 ? 0 : 2;
  }
  /// hi - lo, rounded up.
  [[nodiscard]] constexpr T width() const { return outward::sum_up(hi, -lo); }
  /// A number inside, about halfway; where an end is infinite, some way towards it.
  [[nodiscard]] constexpr T middle() const {
    constexpr T far = T(0x1p16);
    if (hi == infinity<T> && lo == -infinity<T>) return 0;
    if (hi == infinity<T>) return lo < 1 ? T(1) : min(lo * far, std::numeric_limits<T>::max());
    if (lo == -infinity<T>) return hi > -1 ? T(-1) : max(hi * far, std::numeric_limits<T>::lowest());
    const T sum = lo + hi;
    return sum - sum == 0 ? min(hi, max(lo, sum / 2)) : lo / 2 + hi / 2;
  }

  friend constexpr Interval operator-(const Interval& x) { return between(-x.hi, -x.lo); }
  friend constexpr Interval operator+(const Interval& x, const Interval& y) {
    return between(outward::sum_down(x.lo, y.lo), outward::sum_up(x.hi, y.hi));
  }
  friend constexpr Interval operator-(const Interval& x, const Interval& y) { return x + (-y); }
  friend Interval operator*(const Interval& x, const Interval& y) {
    if (x.is_empty() || y.is_empty()) return empty();
    if (x.lo >= 0) return nonnegative_product(x, y);
    if (y.lo >= 0) return nonnegative_product(y, x);
    if (x.hi <= 0) return -nonnegative_product(-x, y);
    if (y.hi <= 0) return -nonnegative_product(-y, x);
    return between(min(outward::product_down(x.lo, y.hi), outward::product_down(x.hi, y.lo)),
                   max(outward::product_up(x.lo, y.lo), outward::product_up(x.hi, y.hi)));
  }
  /// Quotients by 0 do not exist and are left out: X/[0, y] is unbounded on one side, X/[0, 0] empty.
  friend Interval operator/(const Interval& x, const Interval& y) {
    if (x.is_empty() || y.is_empty() || (y.lo == 0 && y.hi == 0)) return empty();
    if (x.lo == 0 && x.hi == 0) return x;
    if (y.lo < 0 && y.hi > 0) return whole();
    return y.hi <= 0 ? -by_nonnegative(x, -y) : by_nonnegative(x, y);
  }

  friend constexpr IntervalMask operator<(const Interval& x, const Interval& y) {
    return {x.lo < y.hi, !(x.hi < y.lo)};
  }
  friend constexpr IntervalMask operator<=(const Interval& x, const Interval& y) {
    return {x.lo <= y.hi, !(x.hi <= y.lo)};
  }
  friend constexpr IntervalMask operator==(const Interval& x, const Interval& y) {
    return {x.lo <= y.hi && y.lo <= x.hi, !(x.is_point() && y.is_point() && x.lo == y.lo)};
  }

 private:
  constexpr Interval(T least, T greatest) : lo(least), hi(greatest) {}

  /// X·Y for a nonnegative X.
  [[nodiscard]] static Interval nonnegative_product(const Interval& x, const Interval& y) {
    return between(outward::product_down(y.lo >= 0 ? x.lo : x.hi, y.lo),
                   outward::product_up(y.hi >= 0 ? x.hi : x.lo, y.hi));
  }
  /// X/Y for a Y of positive numbers and maybe 0.
  [[nodiscard]] static Interval by_nonnegative(const Interval& x, const Interval& y) {
    const T least = x.lo >= 0 ? y.hi : y.lo;
    const T greatest = x.hi <= 0 ? y.hi : y.lo;
    return between(least == 0 ? -infinity<T> : outward::quotient_down(x.lo, least),
                   greatest == 0 ? infinity<T> : outward::quotient_up(x.hi, greatest));
  }
};

}  // namespace rayproof

#include <rayproof/arithmetics/interval_functions.hpp>  // IWYU pragma: export

#include <rayproof/rounding/as_before.hpp>
