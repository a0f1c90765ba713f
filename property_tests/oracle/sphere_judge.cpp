/// \file
/// The judge for ray and sphere. Every formula stands here once, over a ring R; it runs over Interval, Ball
/// and Pair, which know when they can't tell, and then over the exact Ring, which always can.

#include <algorithm>

#include "oracle/judging.hpp"
#include "oracle/sphere.hpp"
#include "oracle/sphere_equation.hpp"

namespace rayproof::oracle {
namespace {

std::optional<int> certain_sign(const Ring& x) { return sign(x); }

/// What was read (`sizes.hpp`) as a double.
double value(double x) { return x; }
double value(const Scaled& x) { return static_cast<double>(x.value()); }
using std::abs, std::sqrt;

/// How far the true value of `x` may lie from read(x).
double uncertainty(const Interval& x) { return x.radius; }
double uncertainty(const Ball& x) { return x.radius; }
double uncertainty(const Pair&) { return 0; }
double uncertainty(const Ring&) { return 0; }

/// The sign of (root - t) for the root on `side`, from the signs at t; a > 0.
int compare(int side, int power, int slope) {
  if (power < 0) return side;
  if (power > 0) return slope > 0 ? -1 : 1;
  return slope * side >= 0 ? 0 : side;
}

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
Number read_as(const R& x) {
  if constexpr (std::is_same_v<R, Ring> && std::is_same_v<Number, double>)
    return x.to_double();
  else
    return read(x);
}

/// The exact verdict, or nothing where R can't tell.
template <class Number, class R>
auto verdict(const SphereEquation<R>& scene, const Ray<double>& ray) {
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
    truth.lower = truth.lower && compare(-1, *power, *slope) * inside >= 0;
    truth.upper = truth.upper && compare(1, *power, *slope) * inside >= 0;
  }
  return Maybe(truth);
}

/// The error of a claimed t against the root on `side`, and the distance of p(t) from the surface in units of
/// `unit`.
struct HitError {
  double ulp;
  double residual;
};

/// The error of a finite t; nothing where R can't tell.
template <class R, class Number>
std::optional<HitError> hit_error(const SphereEquation<R>& scene, const Truth<Number>& truth,
                                  const Number& unit, int side, double t, Precision precision) {
  const PowerAt<R> at = scene.at(t);
  const Number power = read(at.power);
  const Number slope = read(at.slope);
  const Number w = sqrt(abs(truth.discriminant));
  const Number u = side > 0 ? slope : -slope;
  const Number sum = abs(u) + w;
  const bool is_double = !(Number(0) < w);
  // root - t, by the branch that does not cancel: from the slope at a double root, from the power beside a
  // single one.
  Number to_root = (side > 0 ? w - u : u - w) / truth.a;
  double doubt = uncertainty(at.slope) / value(truth.a);
  if (!is_double && Number(0) < u) {
    to_root = (side > 0 ? -power : power) / sum;
    doubt = uncertainty(at.power) / value(sum) + 0x1p-20 * uncertainty(at.slope) / value(truth.a);
    if (uncertainty(at.slope) > 0x1p-20 * value(sum)) return std::nullopt;
  }
  const double error = value(to_root);
  const double ulp = ulp_of(t + error, precision);
  if (std::is_same_v<R, Ball> && !(doubt <= std::max(0x1p-20 * abs(error), 0x1p-30 * ulp)))
    return std::nullopt;

  const Number radius = abs(read(scene.radius));
  const Number distance = sqrt(abs(power + radius * radius));
  return HitError{abs(error) / ulp, value(abs(power) / ((distance + radius) * unit))};
}

/// The error of an infinite or NaN t: right only where the exact root rounds to the same infinity.
HitError infinite_hit_error(const SphereEquation<Ring>& scene, int side, double t, Precision precision) {
  const ExactRoot root({scene.a(), scene.h(), scene.c()}, side);
  const bool right = round_correctly(root, precision) == t;
  return right ? HitError{0, 0} : HitError{HUGE_VAL, HUGE_VAL};
}

/// The lengths a contract speaks of, in the scale of the equation.
template <class Number>
struct Lengths {
  Number size;       ///< S = |origin - center| + radius, as large as a transform makes its parts
  Number radius;     ///< of the sphere
  Number condition;  ///< of the transform, 1 without one
  Number smallest, largest;
};

/// The measures of a problem without a transform.
template <class R>
auto lengths(const SphereEquation<R>& scene, const ObjectRay<R>& ray, const RayQuestion& question,
             const Sphere<double>& sphere) {
  using Number = NumberOf<R>;
  const Number radius = abs(read(scene.radius));
  const Number direction = norm(Vector<R>::from(question.ray.direction));
  if (!ray.map) {
    const Number size = norm(scene.from_center) + radius;
    return Lengths<Number>{size, radius, Number(1), std::min(size, direction), std::max(size, direction)};
  }
  const MapSizes<R> map(*question.transform, *ray.map);
  const Number scale = abs(read(ray.scale));
  const Number to_origin = norm(Vector<R>::from(question.ray.origin)) + norm(ray.map->translation);
  const Number size = map.backward * to_origin + scale * norm(Vector<R>::from(sphere.center)) + radius;
  const auto all = {size / scale, direction, map.forward, scale / map.backward,
                    norm(scene.direction) / scale};
  return Lengths<Number>{size, radius, map.forward * map.backward / scale, std::min(all), std::max(all)};
}

/// How much the radius must change for another verdict, in the scale of the equation.
Scaled distance_to_other_verdict(const SphereEquation<Ring>& scene, const Ray<double>& ray) {
  const Scaled radius = abs(approximate(scene.radius));
  const auto change = [&](const Scaled& power) {
    if (power.sign() == 0) return Scaled{};  // A point has no radius to divide by.
    return abs(power) / (sqrt(abs(power + radius * radius)) + radius);
  };
  const Ring a = scene.a(), h = scene.h();
  // The line touches a sphere whose squared radius is larger by -D/a: the power of its nearest point.
  Scaled nearest = change(approximate(a * scene.c() - h * h) / approximate(a));
  for (const double end : {ray.t_min, ray.t_max}) {
    if (std::isfinite(end)) nearest = std::min(nearest, change(approximate(scene.at(end).power)));
  }
  return nearest;
}

/// log2, rounded down to a whole number.
double log2_of(double x) { return x > 0 ? static_cast<double>(exponent_of(x)) : -HUGE_VAL; }
double log2_of(const Scaled& x) { return x.sign() == 0 ? -HUGE_VAL : static_cast<double>(x.exponent() - 1); }

/// Everything the judge derives from a case in one ring.
template <class R>
struct Bench {
  ObjectRay<R> ray;
  SphereEquation<R> scene;

  Bench(const RayQuestion& question, const Sphere<double>& sphere) : ray(question), scene(ray, sphere) {}
};

/// The judgement of one case. Its exact numbers are made only when a filter could not tell.
class SphereJudge {
 public:
  SphereJudge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision)
      : question_(question), sphere_(sphere), precision_(precision), ball_(question, sphere) {}

  Judgement judge(const RayAnswer& claimed) {
    const auto sizes = lengths(ball_.scene, ball_.ray, question_, sphere_);
    note_lengths(sizes);
    // Doubles serve only far from overflow and underflow (false for NaN too).
    if (judgement_.smallest > -200 && judgement_.largest < 200) {
      const Truth<double> truth = filtered_verdict();
      judge_hits(ball_, truth, sizes, claimed);
    } else {
      const auto exact_sizes = lengths(exact().scene, exact().ray, question_, sphere_);
      note_lengths(exact_sizes);
      judge_hits(exact(), *verdict<Scaled>(exact().scene, question_.ray), exact_sizes, claimed);
    }
    return judgement_;
  }

 private:
  const Bench<Ring>& exact() {
    if (!exact_) exact_.emplace(question_, sphere_);
    return *exact_;
  }

  Truth<double> filtered_verdict() {
    const Bench<Interval> interval(question_, sphere_);
    if (const auto truth = verdict<double>(interval.scene, question_.ray)) return *truth;
    if (const auto truth = verdict<double>(ball_.scene, question_.ray)) return *truth;
    if (const auto truth = verdict<double>(Bench<Pair>(question_, sphere_).scene, question_.ray))
      return *truth;
    return *verdict<double>(exact().scene, question_.ray);
  }

  template <class Number>
  void note_lengths(const Lengths<Number>& sizes) {
    judgement_.far = Number(0) < sizes.radius ? value(sizes.size / sizes.radius) : HUGE_VAL;
    judgement_.smallest = log2_of(sizes.smallest);
    judgement_.largest = log2_of(sizes.largest);
  }

  template <class R, class Number>
  void judge_hits(const Bench<R>& bench, const Truth<Number>& truth, const Lengths<Number>& sizes,
                  const RayAnswer& claimed) {
    const std::size_t expected =
        claimed.nearest_only ? std::min<std::size_t>(truth.count(), 1) : truth.count();
    const Number unit = sizes.size * sizes.condition * Number(unit_roundoff(precision_));
    judgement_.hit = truth.count() > 0;
    judgement_.wrong = expected != claimed.hits.count;
    for (std::size_t i = 0; i < claimed.hits.count; ++i) {
      note_error(claimed.hits.t[i], hit(bench, truth, unit, truth.side(i), claimed.hits.t[i]));
    }
    if (!judgement_.wrong) return;
    judgement_.ulp = std::nan("");
    if (!(Number(0) < abs(truth.discriminant)))
      return;  // a tangent: any change of the radius changes the verdict
    judgement_.margin =
        value(distance_to_other_verdict(exact().scene, question_.ray) / Scaled(static_cast<Scaled>(unit)));
  }

  template <class R, class Number>
  HitError hit(const Bench<R>& bench, const Truth<Number>& truth, const Number& unit, int side, double t) {
    if (!std::isfinite(t)) return infinite_hit_error(exact().scene, side, t, precision_);
    if (const auto error = hit_error(bench.scene, truth, unit, side, t, precision_)) return *error;
    const Truth<Scaled> widened{truth.lower, truth.upper, truth.discriminant, truth.a};
    return *hit_error(exact().scene, widened, Scaled(unit), side, t, precision_);
  }

  void note_error(double t, const HitError& error) {
    judgement_.ulp = std::max(judgement_.ulp, error.ulp);
    if (!is_best_on_grid(t, error.ulp, precision_))
      judgement_.residual = std::max(judgement_.residual, error.residual);
  }

  const RayQuestion& question_;
  const Sphere<double>& sphere_;
  Precision precision_;
  Bench<Ball> ball_;
  std::optional<Bench<Ring>> exact_;
  Judgement judgement_;
};

}  // namespace

Judgement judge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision,
                const RayAnswer& claimed) {
  return SphereJudge(question, sphere, precision).judge(claimed);
}

}  // namespace rayproof::oracle
