#pragma once
/// \file
/// The operations that stand for one another in mutants. Each gives NoMutant for what it can't be applied to.

#include "mutation/planted/planting.hpp"

namespace rayproof::mutation {

struct NotMade {
  static constexpr auto of(const auto&... /*operands*/) { return NoMutant{}; }
};
struct Less {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a < b; })
      return a < b;
    else
      return NoMutant{};
  }
};
struct LessEqual {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a <= b; })
      return a <= b;
    else
      return NoMutant{};
  }
};
struct Greater {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a > b; })
      return a > b;
    else
      return NoMutant{};
  }
};
struct GreaterEqual {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a >= b; })
      return a >= b;
    else
      return NoMutant{};
  }
};
struct Equal {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a == b; })
      return a == b;
    else
      return NoMutant{};
  }
};
struct NotEqual {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a != b; })
      return a != b;
    else
      return NoMutant{};
  }
};
struct Plus {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a + b; })
      return a + b;
    else
      return NoMutant{};
  }
};
struct Minus {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a - b; })
      return a - b;
    else
      return NoMutant{};
  }
};
struct Times {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a* b; })
      return a * b;
    else
      return NoMutant{};
  }
};
struct Over {
  static constexpr auto of(const auto& a, const auto& b) {
    if constexpr (requires { a / b; })
      return a / b;
    else
      return NoMutant{};
  }
};

struct Modulo {
  static constexpr auto of(const auto& a, const auto& b) { return a % b; }
};
struct LeftAlone {
  static constexpr auto of(const auto& a, const auto& /*b*/) { return a; }
};
struct RightAlone {
  static constexpr auto of(const auto& /*a*/, const auto& b) { return b; }
};
struct Same {
  static constexpr auto of(const auto& a) { return a; }
};
struct Negated {
  static constexpr auto of(const auto& a) {
    if constexpr (requires { -a; })
      return -a;
    else
      return NoMutant{};
  }
};
struct MinusReversed {
  static constexpr auto of(const auto& a, const auto& b) { return Minus::of(b, a); }
};
struct OverReversed {
  static constexpr auto of(const auto& a, const auto& b) { return Over::of(b, a); }
};
struct MinusRight {
  static constexpr auto of(const auto& /*a*/, const auto& b) { return Negated::of(b); }
};
struct Not {
  static constexpr auto of(const auto& a) { return !a; }
};
struct True {
  static constexpr bool of(const auto& /*a*/) { return true; }
};
struct False {
  static constexpr bool of(const auto& /*a*/) { return false; }
};
struct One {
  static constexpr auto of(const auto& a) { return std::decay_t<decltype(a)>(1); }
};
struct Twice {
  static constexpr auto of(const auto& a) { return a + a; }
};
struct Half {
  template <class A>
  static constexpr auto of(const A& a) {
    if constexpr (requires { a / A(2); })
      return a / A(2);
    else
      return NoMutant{};
  }
};
/// 2^26 times as large, and as small: far beyond any slack that a bound may have.
struct Huge {
  static constexpr auto of(double a) { return a * 0x1p26; }
};
struct Tiny {
  static constexpr auto of(double a) { return a * 0x1p-26; }
};

}  // namespace rayproof::mutation
