#pragma once
#include <rayproof/arithmetics/error_free.hpp>
#include <rayproof/vec3.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// a·b as if computed in twice the digits and rounded once.
///
/// Source: T. Ogita, S. M. Rump, S. Oishi, "Accurate Sum and Dot Product", 2005, algorithm Dot2.
template <class T>
[[nodiscard]] constexpr T dot_compensated(const vec3<T>& a, const vec3<T>& b) {
  const auto x = two_product(a.x, b.x);
  const auto y = two_product(a.y, b.y);
  const auto z = two_product(a.z, b.z);
  const auto xy = two_sum(x.rounded, y.rounded);
  const auto xyz = two_sum(xy.rounded, z.rounded);
  return xyz.rounded + (x.rest + y.rest + z.rest + xy.rest + xyz.rest);
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
