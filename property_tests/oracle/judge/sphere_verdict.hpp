#pragma once
/// \file
/// The exact verdict of ray and sphere. The formula stands here once, over a ring R; it runs over Interval,
/// Ball and Pair, which know when they can't tell, and then over the exact Ring, which always can.

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "oracle/geometry/sizes.hpp"
#include "oracle/geometry/sphere_equation.hpp"
#include "oracle/numbers/root.hpp"

namespace rayproof::oracle {

[[nodiscard]] inline std::optional<int> certain_sign(const Ring& x) { return sign(x); }

/// What was read (`sizes.hpp`) as a double.
[[nodiscard]] inline double value(double x) { return x; }
[[nodiscard]] inline double value(const Scaled& x) { return static_cast<double>(x.value()); }

/// How far the true value of `x` may lie from read(x).
[[nodiscard]] inline double uncertainty(const Interval& x) { return x.radius; }
[[nodiscard]] inline double uncertainty(const Ball& x) { return x.radius; }
[[nodiscard]] inline double uncertainty(const Pair&) { return 0; }
[[nodiscard]] inline double uncertainty(const Ring&) { return 0; }

/// Which roots lie in the ray's interval, and a quarter of the discriminant to one part in 2^20 (an exact 0
/// is 0).
template <class Number>
struct Truth {
  bool lower = false;
  bool upper = false;
  Number discriminant{0};
  Number a{0};

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(lower) + static_cast<std::size_t>(upper);
  }
  /// The side of the hit that comes `index`-th.
  [[nodiscard]] int side(std::size_t index) const { return index > 0 || !lower ? 1 : -1; }
};

/// A ring's value as a `Number`: as `read` has it, or rounded to a double where doubles serve.
template <class Number, class R>
[[nodiscard]] Number read_as(const R& x) {
  if constexpr (std::is_same_v<R, Ring> && std::is_same_v<Number, double>)
    return x.to_double();
  else
    return read(x);
}

/// The exact verdict, or nothing where R can't tell.
template <class Number, class R>
[[nodiscard]] auto verdict(const SphereEquation<R>& scene, const Ray<double>& ray) {
  using std::abs;
  using Maybe = std::optional<Truth<Number>>;
  const R a = scene.a(), h = scene.h(), c = scene.c();
  const R discriminant = h * h - a * c;
  const auto discriminant_sign = certain_sign(discriminant);
  if (!discriminant_sign) return Maybe();
  Truth<Number> truth{*discriminant_sign >= 0, *discriminant_sign > 0, read_as<Number>(discriminant),
                      read_as<Number>(a)};
  if (uncertainty(discriminant) > 0x1p-20 * abs(value(truth.discriminant))) return Maybe();
  for (const auto& [end, inside] : {std::pair{ray.t_min, 1}, std::pair{ray.t_max, -1}}) {
    if (std::isinf(end)) continue;
    const PowerAt<R> at = end == 0 ? PowerAt<R>{c, h} : scene.at(end);
    const auto power = certain_sign(at.power);
    const auto slope = certain_sign(at.slope);
    if (!power || !slope) return Maybe();
    truth.lower = truth.lower && compare_root(-1, *power, *slope) * inside >= 0;
    truth.upper = truth.upper && compare_root(1, *power, *slope) * inside >= 0;
  }
  return Maybe(truth);
}

}  // namespace rayproof::oracle
