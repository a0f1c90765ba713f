#pragma once
/// \file
/// What the judges of all shapes have in common: the errors of claimed hits against exact ones, and the sizes
/// that the units of the contracts are made of.

#include <cmath>
#include <span>
#include <variant>
#include <vector>

#include "oracle/geometry/hit.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// An exact t, rational or not.
using ExactNumber = std::variant<Quotient, ExactRoot>;

/// The lengths of a ray as the shape's own space has them: |origin| and |direction| without a transform, and
/// with one as large as it can make their parts, times its condition number.
struct RaySizes {
  Scaled origin, direction;

  RaySizes(const RayQuestion& question, const ObjectRay<Ring>& ray);
};

/// What a shape's judge tells of a case. Both measures are in the units of the shape's contract.
class Figure {
 public:
  Figure() = default;
  Figure(const Figure&) = delete;
  Figure& operator=(const Figure&) = delete;
  virtual ~Figure() = default;

  /// The hits in the ray's interval, ascending.
  [[nodiscard]] virtual std::vector<ExactNumber> hits() const = 0;
  /// How far p(t) is from the surface.
  [[nodiscard]] virtual Scaled residual(double t) const = 0;
  /// How near the case is to a change of verdict.
  [[nodiscard]] virtual Scaled margin() const = 0;
  /// The ratio by which naive methods degrade.
  [[nodiscard]] virtual double far() const { return 1; }
};

/// Judges claimed hits against the figure's.
[[nodiscard]] Judgement judge_hits(const RayQuestion& question, const Figure& figure, Precision precision,
                                   const RayAnswer& claimed);

/// The finite ends of the ray's interval.
[[nodiscard]] std::vector<double> finite_ends(const Ray<double>& ray);

/// The error of x in ulps of the exact number; an infinite or NaN x is right only where the exact number
/// rounds to the same infinity.
template <class Number>
[[nodiscard]] double error_in_ulps(const Number& exact, double x, Precision precision) {
  const double nearest = round_correctly(exact, precision);
  if (!std::isfinite(x) || !std::isfinite(nearest)) return x == nearest ? 0 : HUGE_VAL;
  return static_cast<double>((abs(exact.minus(x)) / Scaled(ulp_of(nearest, precision))).value());
}

/// Whether no residual can be asked of x: it is as good as the nearest number where the grid of floats itself
/// is coarse or ends.
[[nodiscard]] inline bool is_best_on_grid(double x, double ulps, Precision precision) {
  const double smallest_normal = precision == Precision::float32 ? 0x1p-126 : 0x1p-1022;
  return ulps <= 1 && (!std::isfinite(x) || std::abs(x) < smallest_normal);
}

/// Puts log2 of the smallest and largest nonzero magnitude among `numbers` into the judgement.
void note_range(std::span<const double> numbers, Judgement& judgement);

/// The smaller of two.
inline void reduce(Scaled& smallest, const Scaled& x) {
  if (x < smallest) smallest = x;
}

/// error / unit; an error of 0 is 0 in units of 0, too.
[[nodiscard]] inline Scaled ratio(const Scaled& error, const Scaled& unit) {
  return error.sign() == 0 ? error : error / unit;
}

/// More than any margin that matters.
[[nodiscard]] inline Scaled endless() { return {1, 1L << 40}; }

}  // namespace rayproof::oracle
