#pragma once
#include <rayproof/arithmetic.hpp>
#include <rayproof/method/narration.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::implicit {

/// The general surface of the second degree, by the coefficients of its ten terms exactly as given:
///
/// xx·x² + yy·y² + zz·z² + yz·y·z + xz·x·z + xy·x·y + xw·x + yw·y + zw·z + ww = 0,
///
/// in homogeneous form with the missing w's. All ten 0 is every point of space.
template <class P>
struct Quadric {
  P xx{}, yy{}, zz{}, yz{}, xz{}, xy{}, xw{}, yw{}, zw{}, ww{};

  template <class T>
  [[nodiscard]] constexpr T operator()(const T& x, const T& y, const T& z, const T& w) const {
    step<T>("Add the ten terms", "The sum f is 0 for the points of the surface and for no others.");
    const T squares = T(xx) * square(x) + T(yy) * square(y) + T(zz) * square(z) + T(ww) * square(w);
    const T mixed = T(yz) * y * z + T(xz) * x * z + T(xy) * x * y;
    return named("f", squares + mixed + (T(xw) * x + T(yw) * y + T(zw) * z) * w);
  }
};

}  // namespace rayproof::implicit

#include <rayproof/rounding/as_before.hpp>
