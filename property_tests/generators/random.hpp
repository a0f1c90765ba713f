#pragma once
/// \file
/// A fast counter-based source of random bits: one 64-bit seed stands for one case.

#include <cstdint>

namespace rayproof {

/// Scrambles 64 bits so that neighbouring numbers have nothing in common.
///
/// Source: G. Steele, D. Lea, C. Flood, "Fast Splittable Pseudorandom Number Generators", 2014 (finaliser by
/// D. Stafford).
[[nodiscard]] constexpr std::uint64_t scramble(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// One seed made of two, in which order counts.
[[nodiscard]] constexpr std::uint64_t combine(std::uint64_t seed, std::uint64_t more) {
  return scramble(seed + 0x9e3779b97f4a7c15U) ^ scramble(more + 0xd1b54a32d192ed03U) * 3U;
}

/// SplitMix64: the state is a counter, so that a generator is made in no time for every case.
///
/// Whoever draws twice in one expression draws in an order that each compiler chooses for itself, be it for
/// the arguments of a call or for the two sides of a sum: there the draws have names, or stand in braces,
/// which are filled from the left. (Unit test `TheCasesOfASeed` holds every family to it.)
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : counter_(scramble(seed)) {}

  [[nodiscard]] constexpr std::uint64_t bits() { return scramble(counter_ += 0x9e3779b97f4a7c15U); }

  /// A whole number from `low` to `high`, both included; their distance must be below 2^31.
  [[nodiscard]] constexpr int between(int low, int high) {
    const auto count = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low) + 1U;
    return low + static_cast<int>(((bits() >> 32U) * count) >> 32U);
  }

  /// True once in `n` times.
  [[nodiscard]] constexpr bool one_in(int n) { return between(1, n) == 1; }

  /// Uniform in [0, 1), 53 bits.
  [[nodiscard]] constexpr double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

  /// Uniform from `low` to `high`, which rounding may give.
  [[nodiscard]] constexpr double uniform(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t counter_;
};

}  // namespace rayproof
