#pragma once
#include <rayproof/arithmetic.hpp>
#include <rayproof/method/narration.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::implicit {

/// All points at distance `minor` from the circle of radius `major` about the origin in the plane z = 0. With
/// `minor` 0 the circle itself, which every ray only touches; with `major` 0 the sphere, met twice at every
/// hit. Both therefore are never certain. Signs do not matter.
///
/// (x² + y² + z² - R² - r²)² + 4R²(z² - r²) = 0: the usual equation with x² + y² taken apart, so that x and y
/// stand in it once, and an interval arithmetic loses less.
template <class P>
struct Torus {
  P major;
  P minor;

  template <class T>
  [[nodiscard]] constexpr T operator()(const T& x, const T& y, const T& z, const T& w) const {
    step<T>("Compare the distance from the centre with that of the circle",
            "k is the squared distance from the centre less R² + r²: 0 on the highest and lowest circle of "
            "the torus.");
    const T RR = named("R²", square(T(major) * w));
    const T rr = named("r²", square(T(minor) * w));
    const T zz = square(z);
    const T from_circle = named("k", square(x) + square(y) + zz - (RR + rr));
    step<T>("Add what the height above the circle's plane makes of it",
            "The second term is 0 at the heights ±r and negative between them, so that f is 0 on the whole "
            "torus.");
    return named("f", square(from_circle) + T(4) * RR * (zz - rr));
  }
};

}  // namespace rayproof::implicit

#include <rayproof/rounding/as_before.hpp>
