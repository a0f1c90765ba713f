/// \file
/// The oracle for ray and sphere. It judges by the cheapest arithmetic that is certain.

#include <optional>
#include <tuple>

#include "oracle/shapes/shapes.hpp"
#include "oracle/shapes/sphere/measures.hpp"

namespace rayproof::oracle {
namespace {

class SphereIntersection final : public ExactIntersection {
 public:
  SphereIntersection(const RayQuestion& question, const Sphere<double>& sphere)
      : ExactIntersection(question), scene_(ray(), sphere) {}

  [[nodiscard]] std::vector<ExactContact> hits() const override {
    std::vector<ExactContact> all;
    std::vector<ExactRoot> roots = real_roots(quadratic_of(scene_));
    const Contact contact = roots.size() == 1 ? Contact::tangent : Contact::crossing;
    for (ExactRoot& t : roots) add(all, std::move(t), contact);
    return all;
  }

  /// None of a point, which is a sphere of radius 0.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact&) const override {
    if (sign(scene_.radius) == 0) return std::nullopt;
    return ExactNormal{scene_.from_center, scene_.direction};
  }

 private:
  SphereEquation<Ring> scene_;
};

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
  for (const double end : finite_ends(ray)) reduce(nearest, change(approximate(scene.at(end).power)));
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
/// the error of a hit, the exact ones when no filter could decide.
class SphereJudge {
 public:
  SphereJudge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision)
      : question_(question), sphere_(sphere), precision_(precision) {}

  Judgement judge(const RayAnswer& claimed) {
    // Without a transform one subtraction makes a coordinate, so that balls would have the same sizes.
    const SphereSizes<double> sizes = question_.transform ? sizes_in<Ball>() : sizes_in<Interval>();
    note_sizes(sizes);
    // Doubles serve only far from overflow and underflow (false for NaN too).
    if (judgement_.smallest > -200 && judgement_.largest < 200) {
      judge_hits<Ball>(filtered_verdict(), sizes, claimed);
    } else {
      const SphereSizes<Scaled> exact_sizes = sizes_in<Ring>();
      note_sizes(exact_sizes);
      judge_hits<Ring>(*verdict<Scaled>(bench<Ring>().scene, question_.ray), exact_sizes, claimed);
    }
    return judgement_;
  }

 private:
  template <class R>
  const Bench<R>& bench() {
    auto& made = std::get<std::optional<Bench<R>>>(benches_);
    if (!made) made.emplace(question_, sphere_);
    return *made;
  }

  template <class R>
  SphereSizes<NumberOf<R>> sizes_in() {
    return sizes_of(bench<R>().scene, bench<R>().ray, question_, sphere_);
  }

  template <class R>
  std::optional<Truth<double>> verdict_in() {
    return verdict<double>(bench<R>().scene, question_.ray);
  }

  Truth<double> filtered_verdict() {
    if (const auto truth = verdict_in<Interval>()) return *truth;
    if (const auto truth = verdict_in<Ball>()) return *truth;
    if (const auto truth = verdict_in<Pair>()) return *truth;
    return *verdict_in<Ring>();
  }

  template <class Number>
  void note_sizes(const SphereSizes<Number>& sizes) {
    judgement_.far = Number(0) < sizes.radius ? value(sizes.size / sizes.radius) : HUGE_VAL;
    judgement_.smallest = log2_of(sizes.smallest);
    judgement_.largest = log2_of(sizes.largest);
  }

  template <class R, class Number>
  void judge_hits(const Truth<Number>& truth, const SphereSizes<Number>& sizes, const RayAnswer& claimed) {
    using std::abs;
    const Number unit = sizes.size * sizes.condition * Number(unit_roundoff(precision_));
    judgement_.hit = truth.count() > 0;
    judgement_.wrong = is_wrong_count(truth.count(), claimed);
    for (std::size_t i = 0; i < claimed.hits.count; ++i) {
      const double t = claimed.hits.t[i];
      const HitError error = hit<R>(truth, unit, truth.side(i), t);
      note_error(
          t, error.ulp, [&] { return error.residual; }, precision_, judgement_);
    }
    if (!judgement_.wrong) return;
    judgement_.ulp = std::nan("");
    if (!(Number(0) < abs(truth.discriminant)))
      return;  // a tangent: any change of the radius changes the verdict
    judgement_.margin = value(distance_to_other_verdict(bench<Ring>().scene, question_.ray) / Scaled(unit));
  }

  template <class R, class Number>
  HitError hit(const Truth<Number>& truth, const Number& unit, int side, double t) {
    if (!std::isfinite(t)) {
      const std::vector<ExactRoot> roots = real_roots(quadratic_of(bench<Ring>().scene));
      if (roots.empty()) return {HUGE_VAL, HUGE_VAL};
      return {error_in_ulps(side < 0 ? roots.front() : roots.back(), t, precision_), HUGE_VAL};
    }
    if (const auto error = hit_error(bench<R>().scene, truth, unit, side, t, precision_)) return *error;
    const Truth<Scaled> widened{truth.lower, truth.upper, truth.discriminant, truth.a};
    return *hit_error(bench<Ring>().scene, widened, Scaled(unit), side, t, precision_);
  }

  const RayQuestion& question_;
  const Sphere<double>& sphere_;
  Precision precision_;
  std::tuple<std::optional<Bench<Interval>>, std::optional<Bench<Ball>>, std::optional<Bench<Pair>>,
             std::optional<Bench<Ring>>>
      benches_;
  Judgement judgement_;
};

}  // namespace

std::unique_ptr<ExactIntersection> intersection_of(const RayQuestion& question,
                                                   const Sphere<double>& sphere) {
  return std::make_unique<SphereIntersection>(question, sphere);
}

Judgement judge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision,
                const RayAnswer& claimed) {
  return SphereJudge(question, sphere, precision).judge(claimed);
}

}  // namespace rayproof::oracle
