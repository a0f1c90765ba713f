#pragma once
/// \file
/// Double-doubles as expansions, to compare what was computed with what is exact.

#include <cstddef>
#include <rayproof/arithmetics/double_double.hpp>
#include <rayproof/arithmetics/expansion.hpp>

namespace rayproof {

[[nodiscard]] inline Expansion<double, 2> exact_of(const DoubleDouble<double>& x) {
  return exact(x.low()) + exact(x.high());
}

template <std::size_t N>
[[nodiscard]] Expansion<double, N> magnitude(const Expansion<double, N>& x) {
  return sign(x) < 0 ? -x : x;
}

}  // namespace rayproof
