/// \file
/// The judge for ray and sphere: the verdict and the errors by the cheapest arithmetic that can tell.

#include <algorithm>
#include <optional>
#include <tuple>

#include "oracle/judge/judging.hpp"
#include "oracle/judge/sphere_error.hpp"
#include "oracle/judge/sphere_verdict.hpp"
#include "oracle/shapes/sphere.hpp"

namespace rayproof::oracle {
namespace {

using std::abs;

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

/// The judgement of one case. A ring's numbers are made only when they are asked for: those of the balls for
/// the error of a hit, the exact ones when no filter could tell.
class SphereJudge {
 public:
  SphereJudge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision,
              Judgement& judgement)
      : question_(question), sphere_(sphere), precision_(precision), judgement_(judgement) {}

  void judge(const RayAnswer& claimed) {
    // Without a transform one subtraction makes a coordinate, so that balls would have the same sizes.
    const Lengths<double> sizes = question_.transform ? lengths_in<Ball>() : lengths_in<Interval>();
    note_lengths(sizes);
    // Doubles serve only far from overflow and underflow (false for NaN too).
    if (judgement_.smallest > -200 && judgement_.largest < 200) {
      judge_hits<Ball>(filtered_verdict(), sizes, claimed);
    } else {
      const Lengths<Scaled> exact_sizes = lengths_in<Ring>();
      note_lengths(exact_sizes);
      judge_hits<Ring>(*verdict_in<Ring, Scaled>(), exact_sizes, claimed);
    }
  }

 private:
  template <class R>
  const Bench<R>& bench() {
    auto& made = std::get<std::optional<Bench<R>>>(benches_);
    if (!made) made.emplace(question_, sphere_);
    return *made;
  }

  template <class R>
  Lengths<NumberOf<R>> lengths_in() {
    return lengths(bench<R>().scene, bench<R>().ray, question_, sphere_);
  }

  template <class R, class Number>
  std::optional<Truth<Number>> verdict_in() {
    return verdict<Number>(bench<R>().scene, question_.ray);
  }

  Truth<double> filtered_verdict() {
    if (const auto truth = verdict_in<Interval, double>()) return *truth;
    if (const auto truth = verdict_in<Ball, double>()) return *truth;
    if (const auto truth = verdict_in<Pair, double>()) return *truth;
    return *verdict_in<Ring, double>();
  }

  template <class Number>
  void note_lengths(const Lengths<Number>& sizes) {
    judgement_.far = Number(0) < sizes.radius ? value(sizes.size / sizes.radius) : HUGE_VAL;
    judgement_.smallest = log2_of(sizes.smallest);
    judgement_.largest = log2_of(sizes.largest);
  }

  template <class R, class Number>
  void judge_hits(const Truth<Number>& truth, const Lengths<Number>& sizes, const RayAnswer& claimed) {
    const std::size_t expected =
        claimed.nearest_only ? std::min<std::size_t>(truth.count(), 1) : truth.count();
    const Number unit = sizes.size * sizes.condition * Number(unit_roundoff(precision_));
    judgement_.hit = truth.count() > 0;
    judgement_.wrong = expected != claimed.hits.count;
    for (std::size_t i = 0; i < claimed.hits.count; ++i) {
      note_error(claimed.hits.t[i], hit<R>(truth, unit, truth.side(i), claimed.hits.t[i]));
    }
    if (!judgement_.wrong) return;
    judgement_.ulp = std::nan("");
    if (!(Number(0) < abs(truth.discriminant)))
      return;  // a tangent: any change of the radius changes the verdict
    judgement_.margin = value(distance_to_other_verdict(bench<Ring>().scene, question_.ray) /
                              Scaled(static_cast<Scaled>(unit)));
  }

  template <class R, class Number>
  HitError hit(const Truth<Number>& truth, const Number& unit, int side, double t) {
    if (!std::isfinite(t)) return infinite_hit_error(bench<Ring>().scene, side, t, precision_);
    if (const auto error = hit_error(bench<R>().scene, truth, unit, side, t, precision_)) return *error;
    const Truth<Scaled> widened{truth.lower, truth.upper, truth.discriminant, truth.a};
    return *hit_error(bench<Ring>().scene, widened, Scaled(unit), side, t, precision_);
  }

  void note_error(double t, const HitError& error) {
    judgement_.ulp = std::max(judgement_.ulp, error.ulp);
    if (!is_best_on_grid(t, error.ulp, precision_))
      judgement_.residual = std::max(judgement_.residual, error.residual);
  }

  const RayQuestion& question_;
  const Sphere<double>& sphere_;
  Precision precision_;
  std::tuple<std::optional<Bench<Interval>>, std::optional<Bench<Ball>>, std::optional<Bench<Pair>>,
             std::optional<Bench<Ring>>>
      benches_;
  Judgement& judgement_;
};

}  // namespace

Judgement judge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision,
                const RayAnswer& claimed) {
  Judgement judgement;
  SphereJudge(question, sphere, precision, judgement).judge(claimed);
  return judgement;
}

}  // namespace rayproof::oracle
