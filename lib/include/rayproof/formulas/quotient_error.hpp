#pragma once
/// \file
/// Bounds on the rounding of sums of products and of their quotients, for what is computed in double on
/// numbers that are floats: their products are exact.

#include <rayproof/vec3.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// |a.x·b.x| + |a.y·b.y| + |a.z·b.z|: what the rounding of a·b is measured by.
template <class W>
[[nodiscard]] constexpr W size_of_dot(const vec3<W>& a, const vec3<W>& b) {
  return abs(a.x * b.x) + abs(a.y * b.y) + abs(a.z * b.z);
}

/// The same for (a × b)·c.
template <class W>
[[nodiscard]] constexpr W size_of_volume(const vec3<W>& a, const vec3<W>& b, const vec3<W>& c) {
  return (abs(a.y * b.z) + abs(a.z * b.y)) * abs(c.x) + (abs(a.z * b.x) + abs(a.x * b.z)) * abs(c.y) +
         (abs(a.x * b.y) + abs(a.y * b.x)) * abs(c.z);
}

/// Whether a divisor L, off by at most 4.2u times its size, keeps its sign and nearly all digits.
template <class W>
[[nodiscard]] constexpr Mask<W> has_digits(const W& L, const W& size_of_L) {
  return W(0x1p-20) * size_of_L < abs(L);
}

/// A bound on the error of a quotient x = N / L whose divisor has digits, where N is off by at most 6.2u
/// times its size, with u = 2^-53. N's share is 6.2u·size/|L|, that of L and of the
/// division 5.2u·|x|·size_of_L/|L|; the rest of the 10u is for the roundings of those who use it, as many as
/// four. `per_L` is no less than 1/|L|.
template <class W>
[[nodiscard]] constexpr W quotient_error(const W& x, const W& size_of_N, const W& size_of_L, const W& per_L) {
  return W(0x1.4p-50) * (size_of_N + abs(x) * size_of_L) * per_L;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
