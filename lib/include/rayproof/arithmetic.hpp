#pragma once
/// \file
/// The vocabulary every kernel is written in, and its meaning in the plain arithmetics `float` and `double`.
///
/// A kernel is a template over its number type `T`. It may use `+ - * /`, comparisons (which give a
/// `Mask<T>`), and the functions of this file, called unqualified so that an arithmetic brings its own by
/// argument-dependent lookup. A new arithmetic is a type with these operations: see
/// docs/add-an-arithmetic.md.

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

// A miss is an infinite t or a NaN, and the exact methods count on every rounding as written. -ffast-math,
// -Ofast and -ffinite-math-only allow the compiler to ignore both; g++ has macros for their parts, too.
#if !defined RAYPROOF_ALLOW_FAST_MATH && \
    (defined __FAST_MATH__ || __FINITE_MATH_ONLY__ || __ASSOCIATIVE_MATH__ || __RECIPROCAL_MATH__)
#error "rayproof needs NaN, infinity and exact rounding: compile without -ffast-math (docs/library.md)"
#endif

namespace rayproof {

/// A type of plain numbers all of which a double holds, so that what rounding takes from one is found there.
template <class U>
concept HeldByDouble =
    std::is_arithmetic_v<U> && std::numeric_limits<U>::digits <= std::numeric_limits<double>::digits;

/// What a comparison of two `T` gives: `bool`, or one bool per lane of a SIMD pack.
template <class T>
using Mask = decltype(T() < T());

/// `yes` where `mask` holds, `no` elsewhere: the branch-free `?:` of the kernels.
template <std::floating_point T>
[[nodiscard]] constexpr T select(bool mask, T yes, T no) {
  return mask ? yes : no;
}

// Plain numbers have these from the C library. copysign(x, sign) is the magnitude of x with the sign bit of
// `sign`, -x for -0; floor is the whole number nearest below; fma(x, y, z) is x*y + z, rounded once. Kernels
// are compiled with contraction off: a fused operation is always written out.
using std::abs;
using std::copysign;
using std::floor;
using std::fma;
using std::sqrt;

/// x·x. An interval brings its own, which knows that no square is negative.
template <class T>
[[nodiscard]] constexpr T square(const T& x) {
  return x * x;
}

/// The smaller of two numbers; where one is NaN, either may come back.
template <std::floating_point T>
[[nodiscard]] constexpr T min(T x, T y) {
  return y < x ? y : x;
}

/// The larger of two numbers; where one is NaN, either may come back.
template <std::floating_point T>
[[nodiscard]] constexpr T max(T x, T y) {
  return x < y ? y : x;
}

/// The exponent e with 2^e <= |x| < 2^(e+1), as a `T`; -infinity for 0, infinity for infinity.
template <std::floating_point T>
[[nodiscard]] inline T exponent(T x) {
  return std::logb(x);
}

/// x * 2^e for a whole number e, rounded once (only where the result is subnormal) or to infinity. An e that
/// is infinite or NaN scales as a very large one does, so that no value of e is undefined.
template <std::floating_point T>
[[nodiscard]] inline T scale_exponent(T x, T e) {
  constexpr T beyond_all = 4000;
  return std::ldexp(x, static_cast<int>(max(-beyond_all, min(beyond_all, e))));
}

/// The same number in double, exactly, and a number in double rounded to float once. An arithmetic that
/// rounds in float brings its own two; between them the product of two of its numbers is exact.
template <std::same_as<float> T>
[[nodiscard]] constexpr double widen(T x) {
  return x;
}
template <std::same_as<double> T>
[[nodiscard]] constexpr float narrow(T x) {
  return static_cast<float>(x);
}

/// The float nearest to a number in double, still in double.
template <std::same_as<double> T>
[[nodiscard]] constexpr T to_nearest_float(T x) {
  return static_cast<float>(x);
}

/// Whether the compiler sees, where this becomes part of the code around it, that x is 0.
template <std::floating_point T>
[[nodiscard]] constexpr bool is_known_zero(T x) {
  return __builtin_constant_p(x) && x == 0;
}

/// Between 1/x and 1.125/x for a normal number x > 0, as cheaply as an arithmetic can: for error bounds.
template <std::floating_point T>
[[nodiscard]] constexpr T reciprocal_bound(T x) {
  return (1 + 4 * std::numeric_limits<T>::epsilon()) / x;
}

/// Base of an arithmetic with `<`, `<=` and `==`: its other comparisons, made of these.
template <class A>
struct Comparable {
  friend constexpr auto operator>(const A& x, const A& y) { return y < x; }
  friend constexpr auto operator>=(const A& x, const A& y) { return y <= x; }
  friend constexpr auto operator!=(const A& x, const A& y) { return !(x == y); }
};

/// The plain type an arithmetic rounds in, which is its member `Plain`: `float` for `float`, for a pack of
/// floats, for a recorded float.
template <class T>
struct PlainOf {
  using type = T;
};
template <class A>
requires requires { typename A::Plain; }
struct PlainOf<A> {
  using type = typename A::Plain;
};
template <class T>
using Plain = typename PlainOf<T>::type;

/// An arithmetic in which a kernel may branch on a comparison: plain numbers, and one that says so by a
/// member `may_branch`, because it keeps account of what its masks decide.
template <class T>
concept Branching = std::floating_point<T> || requires {
  requires T::may_branch;
};

/// Infinity, NaN, and the number of digits of the significand in the arithmetic `T`.
template <class T>
inline constexpr Plain<T> infinity = std::numeric_limits<Plain<T>>::infinity();
template <class T>
inline constexpr Plain<T> not_a_number = std::numeric_limits<Plain<T>>::quiet_NaN();
template <class T>
inline constexpr int digits = std::numeric_limits<Plain<T>>::digits;

/// What one operation is off by at most, in parts of its result; a sum of numbers in several parts, in parts
/// of the sizes of its terms.
template <class T>
inline constexpr Plain<T> unit_roundoff = std::numeric_limits<Plain<T>>::epsilon() / 2;

/// What stands for a number, or a vector, where its size is wanted and not its last digits: itself. An
/// arithmetic of several parts brings its own, which gives the largest of them.
template <class T>
[[nodiscard]] constexpr const T& leading(const T& x) {
  return x;
}
template <class T>
using Leading = std::remove_cvref_t<decltype(leading(std::declval<const T&>()))>;

}  // namespace rayproof
