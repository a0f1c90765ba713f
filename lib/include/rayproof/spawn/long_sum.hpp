#pragma once
#include <rayproof/arithmetics/error_free.hpp>
#include <rayproof/spawn/surface_point.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn::detail {

/// Sums of products in twice the digits (T. Ogita, S. M. Rump, S. Oishi, "Accurate Sum and Dot Product",
/// 2005, algorithm Dot2): `value()` is off by 2ε of itself and by 4(n+2)ε² of `size`, the sum of the n
/// magnitudes.
template <std::floating_point T>
struct LongSum {
  T high = 0, low = 0, size = 0;
  int terms = 0;

  void add_product(T a, T b) {
    const ErrorFree<T> product = two_product(a, b), total = two_sum(high, product.rounded);
    high = total.rounded;
    low += total.rest + product.rest;
    size += abs(product.rounded);
    ++terms;
  }
  [[nodiscard]] T value() const { return high + low; }
  [[nodiscard]] T bound() const {
    return 4 * T(terms + 2) * unit<T> * unit<T> * size + 2 * unit<T> * abs(value());
  }
};

/// a·b as if computed in twice the digits and rounded once.
template <std::floating_point T>
[[nodiscard]] T dot_compensated(const vec3<T>& a, const vec3<T>& b) {
  LongSum<T> sum;
  for (int i = 0; i < 3; ++i) sum.add_product(a[i], b[i]);
  return sum.value();
}

}  // namespace rayproof::spawn::detail

#include <rayproof/rounding/as_before.hpp>
