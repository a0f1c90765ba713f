#pragma once
/// \file
/// Rounding to either side without touching the processor's rounding mode: round to nearest, find out by the
/// exact rounding error on which side that fell, and take one step outward where it fell inside.
///
/// An exact result is not widened, so that small whole numbers stay points. Where the error itself may have
/// been lost (overflow, results near the subnormals) the step is taken unasked.

#include <bit>
#include <cstdint>
#include <limits>
#include <rayproof/arithmetics/error_free.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::outward {

template <class T>
using Bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

/// The next number above x: the least positive one for 0, infinity for the greatest. Infinity and NaN stay.
template <std::floating_point T>
[[nodiscard]] constexpr T above(T x) {
  if (!(x < infinity<T>)) return x;
  if (x == 0) return std::numeric_limits<T>::denorm_min();
  return std::bit_cast<T>(static_cast<Bits<T>>(std::bit_cast<Bits<T>>(x) + (x > 0 ? 1 : -1)));
}
/// The next number below x; the greatest finite one for infinity.
template <std::floating_point T>
[[nodiscard]] constexpr T below(T x) {
  return -above(-x);
}

/// A rounded number, or its neighbour below, whichever is not above the exact one. `rest` has the sign of
/// (exact - rounded), and is NaN or infinite where that is not known.
template <std::floating_point T>
[[nodiscard]] constexpr T down(T rounded, double rest) {
  if (rounded == infinity<T>) return std::numeric_limits<T>::max();
  return rest >= 0 && rest < infinity<double> ? rounded : below(rounded);
}
/// The same for above.
template <std::floating_point T>
[[nodiscard]] constexpr T up(T rounded, double rest) {
  return -down(-rounded, -rest);
}

/// x·y + z where that is what rounding left of a product, quotient or root: with the sign of the exact value.
/// Products of floats are exact in double, and so is the sum; of doubles the rest may be lost to underflow
/// where the least number involved is as small as `least`, and is NaN there.
template <std::floating_point T>
[[nodiscard]] inline double rest(T x, T y, T z, T least) {
  if constexpr (sizeof(T) < sizeof(double)) {
    return double{x} * double{y} + double{z};
  } else {
    return least < 0x1p-950 ? not_a_number<double> : fma(x, y, z);
  }
}

/// Sums, products, quotients and roots, rounded down or up. As the end of an interval infinity means "every
/// number, however large", so 0 times it is 0. What underflows keeps its sign: it ends at 0, not beyond.
template <std::floating_point T>
[[nodiscard]] constexpr T sum_down(T x, T y) {
  return down(x + y, two_sum(x, y).rest);
}
template <std::floating_point T>
[[nodiscard]] constexpr T sum_up(T x, T y) {
  return up(x + y, two_sum(x, y).rest);
}
template <std::floating_point T>
[[nodiscard]] inline T product_down(T x, T y) {
  const T product = x * y;
  if (x == 0 || y == 0 || (product == 0 && (x > 0) == (y > 0))) return 0;
  return down(product, rest(x, y, -product, abs(product)));
}
template <std::floating_point T>
[[nodiscard]] inline T product_up(T x, T y) {
  return -product_down(-x, y);
}
template <std::floating_point T>
[[nodiscard]] inline T quotient_down(T x, T y) {
  const T quotient = x / y;
  if (x == 0 || (quotient == 0 && (x > 0) == (y > 0))) return 0;
  const double toward = y > 0 ? 1 : -1;
  return down(quotient, toward * rest(-quotient, y, x, min(abs(x), abs(quotient))));
}
template <std::floating_point T>
[[nodiscard]] inline T quotient_up(T x, T y) {
  return -quotient_down(-x, y);
}
template <std::floating_point T>
[[nodiscard]] inline T root_down(T x) {
  if (x == 0) return 0;
  const T root = sqrt(x);
  return down(root, rest(-root, root, x, x));
}
template <std::floating_point T>
[[nodiscard]] inline T root_up(T x) {
  if (x == 0) return 0;
  if (x == infinity<T>) return x;
  const T root = sqrt(x);
  return up(root, rest(-root, root, x, x));
}

}  // namespace rayproof::outward

#include <rayproof/rounding/as_before.hpp>
