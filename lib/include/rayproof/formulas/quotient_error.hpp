#pragma once
/// \file
/// Bounds on the rounding of quotients of sums of products, for what is computed in double on numbers that
/// are floats, or in double-double on doubles: their products are exact.

#include <rayproof/arithmetics/sized.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Whether a divisor L, off by at most 4.2u times its size, keeps its sign and nearly all digits.
template <class W>
[[nodiscard]] constexpr Mask<W> has_digits(const Sized<W>& L) {
  using N = Leading<W>;
  return N(0x1p33 * unit_roundoff<W>) * L.size < abs(leading(L.value));
}

/// A bound on the error of x = N / L whose divisor has digits, where N is off by at most 6.2u times its size,
/// with u the unit roundoff. N's share is 6.2u·size/|L|, that of L and of the division 5.2u·|x|·size/|L|; the
/// rest of the 10u is for the roundings of those who use it, as many as four. `per_L` is no less than 1/|L|.
template <class W>
[[nodiscard]] constexpr Leading<W> quotient_error(const W& x, const Leading<W>& size_of_N,
                                                  const Leading<W>& size_of_L, const Leading<W>& per_L) {
  return Leading<W>(10 * unit_roundoff<W>) * (size_of_N + abs(leading(x)) * size_of_L) * per_L;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
