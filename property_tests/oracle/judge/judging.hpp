#pragma once
/// \file
/// What the judges of all questions have in common: the errors of claimed numbers against exact ones, in the
/// units of the contracts.

#include <algorithm>
#include <cmath>
#include <vector>

#include "case/each_number.hpp"
#include "oracle/geometry/intersection.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/numbers/ulp.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::oracle {

/// Judges claimed hits against the exact ones.
[[nodiscard]] Judgement judge(const ExactIntersection& exact, Precision precision, const RayAnswer& claimed);

/// Judges what they say of their first hit beside t.
[[nodiscard]] Details judge_details(const ExactIntersection& exact, Precision precision,
                                    const RayAnswer& claimed);

/// What `judge` says by estimates where they are enough, else by exact numbers.
template <class Judge>
[[nodiscard]] Judgement filtered(const Judge& judge) {
  {
    const Filtering by_estimates;
    Doubt::clear();
    if (const Judgement judgement = judge(); !Doubt::is_noted()) return judgement;
  }
  return judge();
}

/// The finite ends of the ray's interval.
[[nodiscard]] std::vector<double> finite_ends(const Ray<double>& ray);

/// A measure in units of ε.
template <class Size>
[[nodiscard]] double in_units(const Size& measure, Precision precision) {
  return value(measure / Size(roundoff_of(precision)));
}

/// Whether `claimed` has another count of hits than the exact one, as far as it speaks of that.
[[nodiscard]] inline bool is_wrong_count(std::size_t exact, const RayAnswer& claimed) {
  if (claimed.verdict_only) return (claimed.hits.count > 0) != (exact > 0);
  return claimed.hits.count != (claimed.nearest_only ? std::min<std::size_t>(exact, 1) : exact);
}

/// read(number), of one of several kinds.
template <class Read, class Number>
[[nodiscard]] double visit_number(const Read& read, const Number& number) {
  return read(number);
}
template <class Read, class... Numbers>
[[nodiscard]] double visit_number(const Read& read, const std::variant<Numbers...>& number) {
  return std::visit(read, number);
}

/// The error of x in ulps of the exact number; an infinite or NaN x is right only where the exact number
/// rounds to the same infinity.
template <class Number>
[[nodiscard]] double error_in_ulps(const Number& exact, double x, Precision precision) {
  const double nearest = round_correctly(exact, precision);
  if (!std::isfinite(x) || !std::isfinite(nearest)) return x == nearest ? 0 : HUGE_VAL;
  using std::abs;
  using Size = SizeOf<typename Number::Over>;
  return value(abs(exact.minus(x)) / Size(ulp_of(nearest, precision)));
}

/// Notes the worst of the claimed numbers' errors: x is off by `ulps`, and residual() is what it leaves, in
/// units. No residual can be asked of an x that is as good as the nearest number where the grid of floats
/// itself is coarse or ends.
template <class Residual>
void note_error(Judgement& judgement, Precision precision, double x, double ulps, const Residual& residual) {
  if (!judgement.wrong) judgement.ulp = std::max(judgement.ulp, ulps);
  const double smallest_normal = precision == Precision::float32 ? 0x1p-126 : 0x1p-1022;
  if (ulps <= 1 && (!std::isfinite(x) || std::abs(x) < smallest_normal)) return;
  judgement.residual = std::max(judgement.residual, std::isfinite(x) ? residual() : HUGE_VAL);
}

/// Notes the errors of claimed hits, which are as many as `hits` where the verdict is right; residual_at(t)
/// says how far p(t) is from the surface.
template <class Hits, class ResidualAt>
void note_errors(Judgement& judgement, const Hits& hits, Precision precision, const RayAnswer& claimed,
                 const ResidualAt& residual_at) {
  if (claimed.verdict_only) return;
  for (std::size_t i = 0; i < claimed.hits.count; ++i) {
    const double t = claimed.hits.t[i];
    const auto ulps_from = [&](const auto& number) { return error_in_ulps(number, t, precision); };
    const double ulps = judgement.wrong ? HUGE_VAL : visit_number(ulps_from, hits[i].t);
    note_error(judgement, precision, t, ulps, [&] { return in_units(residual_at(t), precision); });
  }
}

/// The smallest and the largest nonzero magnitude of some numbers.
class Magnitudes {
 public:
  /// Of all numbers of a value.
  template <class Value>
  void note(const Value& value) {
    each_number(value, [this](double x) {
      const double size = std::abs(x);
      smallest_ = std::min(smallest_, size == 0 ? HUGE_VAL : size);
      largest_ = std::max(largest_, size);
    });
  }
  /// Whether the log2 of all are between -most and most.
  [[nodiscard]] bool are_within(int most) const {
    return smallest_ > std::ldexp(1.0, -most) && largest_ < std::ldexp(1.0, most);
  }
  void put(Judgement& judgement) const {
    judgement.smallest = std::logb(smallest_);
    judgement.largest = std::logb(largest_);
  }

 private:
  double smallest_ = HUGE_VAL, largest_ = 0;
};

/// The numbers of the ray, the shape and the transform.
template <class Shape>
void note_lengths(Magnitudes& lengths, const RayQuestion& question, const Shape& shape) {
  lengths.note(question.ray.origin);
  lengths.note(question.ray.direction);
  lengths.note(shape);
  for (int column = 0; question.transform && column < 4; ++column)
    lengths.note(glm::dvec3((*question.transform)[column]));
}
/// The size of the inverse of the case's map.
template <class R>
[[nodiscard]] SizeOf<R> size_of_inverse(const ObjectRay<R>& ray) {
  return length_of(ray.map->row_x, ray.map->row_y, ray.map->row_z) / approximate(ray.scale);
}

/// The smaller of two.
template <class Size>
void reduce(Size& smallest, const Size& x) {
  if (x < smallest) smallest = x;
}

/// More than any margin that matters.
[[nodiscard]] inline Scaled endless() { return {1, 1L << 40}; }
template <class R>
[[nodiscard]] SizeOf<R> endless_of() {
  if constexpr (std::is_same_v<R, Estimate>)
    return HUGE_VALL;
  else
    return endless();
}

}  // namespace rayproof::oracle
