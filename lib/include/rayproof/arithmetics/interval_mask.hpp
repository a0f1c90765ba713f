#pragma once
/// \file
/// What a comparison of two intervals gives: yes, no, or either.

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

}  // namespace rayproof
