#pragma once
/// \file
/// The exact verdict on a ray and a sphere, and the error of a claimed hit, by filters.

#include <optional>
#include <utility>

#include "oracle/numbers/ulp.hpp"
#include "oracle/shapes/sphere/equation.hpp"

namespace rayproof::oracle {

/// Which roots lie in the ray's interval, and a quarter of the discriminant to one part in 2^20.
struct Truth {
  bool lower, upper;
  bool is_tangent;  ///< the discriminant is 0
  double discriminant, a;

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(lower) + static_cast<std::size_t>(upper);
  }
  /// The side of the hit that comes `index`-th.
  [[nodiscard]] int side(std::size_t index) const { return index > 0 || !lower ? 1 : -1; }
};

/// The exact verdict, or nothing where R can't decide.
template <class R>
[[nodiscard]] std::optional<Truth> verdict(const SphereEquation<R>& scene, const Ray<double>& ray) {
  const R a = scene.a(), h = scene.h(), c = scene.c();
  const R discriminant = h * h - a * c;
  const auto side = certain_sign(discriminant);
  if (!side) return std::nullopt;
  Truth truth{*side >= 0, *side > 0, *side == 0, value(read(discriminant)), value(read(a))};
  if (uncertainty(discriminant) > 0x1p-20 * std::abs(truth.discriminant)) return std::nullopt;
  for (const auto& [end, inside] : {std::pair{ray.t_min, 1}, std::pair{ray.t_max, -1}}) {
    if (std::isinf(end)) continue;
    const PowerAt<R> at = end == 0 ? PowerAt<R>{c, h} : scene.at(end);
    const auto power = certain_sign(at.power);
    const auto slope = certain_sign(at.slope);
    if (!power || !slope) return std::nullopt;
    truth.lower = truth.lower && compare_root(-1, *power, *slope) * inside >= 0;
    truth.upper = truth.upper && compare_root(1, *power, *slope) * inside >= 0;
  }
  return truth;
}

/// The error of a claimed t against the root on `side`, and the distance of p(t) from the surface in units of
/// `unit`.
struct HitError {
  double ulp;
  double residual;
};

/// The error of a finite t; nothing where balls can't decide.
[[nodiscard]] inline std::optional<HitError> hit_error(const SphereEquation<Ball>& scene, const Truth& truth,
                                                       double unit, int side, double t, Precision precision) {
  const PowerAt<Ball> at = scene.at(t);
  const double power = read(at.power), slope = read(at.slope);
  const double w = std::sqrt(std::abs(truth.discriminant));
  const double u = side > 0 ? slope : -slope;
  const double sum = std::abs(u) + w;
  // root - t, by the branch that does not cancel: from the slope at a double root, from the power beside a
  // single one.
  const bool by_power = !truth.is_tangent && u > 0;
  if (by_power && uncertainty(at.slope) > 0x1p-20 * sum) return std::nullopt;
  const double to_root = by_power ? (side > 0 ? -power : power) / sum : (side > 0 ? w - u : u - w) / truth.a;
  const double ulp = ulp_of(t + to_root, precision);
  const double of_slope = uncertainty(at.slope) / truth.a;
  const double doubt = by_power ? uncertainty(at.power) / sum + 0x1p-20 * of_slope : of_slope;
  if (!(doubt <= std::max(0x1p-20 * std::abs(to_root), 0x1p-30 * ulp))) return std::nullopt;
  return HitError{std::abs(to_root) / ulp,
                  std::abs(power) / (reach_of(power, std::abs(read(scene.radius))) * unit)};
}

}  // namespace rayproof::oracle
