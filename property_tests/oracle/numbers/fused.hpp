#pragma once
/// \file
/// Estimates by the processor's own fused multiply-add.

namespace rayproof::oracle {

#if defined(__x86_64__) && !defined(__FMA__)

/// `compute` and all that is inlined into it, compiled for processors that have one.
template <class Compute>
[[gnu::target("fma"), gnu::flatten]] auto fused(const Compute& compute) {
  return compute();
}

/// What `compute` comes to. The rounding error of a product is a std::fma (filters.hpp), which is one
/// instruction where the processor has it, and a function call in code that is compiled for any. Both give
/// the same bits.
template <class Compute>
[[gnu::always_inline]] inline auto with_fused_products(const Compute& compute) {
  static const bool has_fma = __builtin_cpu_supports("fma") != 0;
  return has_fma ? fused(compute) : compute();
}

#else

template <class Compute>
[[gnu::always_inline]] inline auto with_fused_products(const Compute& compute) {
  return compute();
}

#endif

}  // namespace rayproof::oracle
