/// \file
/// The oracle for ray and sphere. It judges by the cheapest arithmetic that is certain.

#include <tuple>

#include "oracle/shapes/shapes.hpp"
#include "oracle/shapes/sphere/equation.hpp"

namespace rayproof::oracle {
namespace {

class SphereIntersection final : public ExactIntersection {
 public:
  SphereIntersection(const RayQuestion& question, const Sphere<double>& sphere)
      : ExactIntersection(question), scene_(ray(), sphere) {}

  [[nodiscard]] ExactContacts hits() const override {
    ExactContacts all;
    RootList roots = roots_of(scene_);
    const Contact contact = roots.size() == 1 ? Contact::tangent : Contact::crossing;
    for (ExactRoot& t : roots) add(all, std::move(t), contact);
    return all;
  }

  /// None of a point, which is a sphere of radius 0.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact&) const override {
    if (sign(scene_.radius) == 0) return std::nullopt;
    return ExactNormal{scene_.from_center, scene_.ray.direction};
  }

 private:
  SphereEquation<Ring> scene_;
};

/// How far the surface is from a point of this power, in the scale of the equation: as much must the radius
/// change for the point to lie on it.
Scaled distance_of(const Scaled& power, const SphereEquation<Ring>& scene) {
  if (power.sign() == 0) return {};  // A point has no radius to divide by.
  return abs(power) / far_side(power, abs(approximate(scene.radius)));
}

/// How much the radius must change for another verdict, in the scale of the equation.
Scaled distance_to_other_verdict(const SphereEquation<Ring>& scene, const Ray<double>& ray) {
  const Ring a = scene.a(), h = scene.h();
  // The line touches a sphere whose squared radius is larger by -D/a: the power of its nearest point.
  Scaled nearest = distance_of(approximate(a * scene.c() - h * h) / approximate(a), scene);
  for (const double end : finite_ends(ray))
    reduce(nearest, distance_of(approximate(scene.at(end).power), scene));
  return nearest;
}

/// log2, rounded down to a whole number.
double log2_of(double x) { return x > 0 ? static_cast<double>(exponent_of(x)) : -HUGE_VAL; }
double log2_of(const Scaled& x) { return x.sign() == 0 ? -HUGE_VAL : static_cast<double>(x.exponent() - 1); }

/// The judgement of one case. A ring's equation is made only when it is asked for: that of the balls for the
/// error of a hit, the exact one when no filter could decide.
class SphereJudge {
 public:
  SphereJudge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision)
      : question_(question), sphere_(sphere), precision_(precision) {}

  Judgement judge(const RayAnswer& claimed) {
    // Without a transform one subtraction makes a coordinate, so that balls would have the same sizes.
    const double unit = question_.transform ? unit_in<Ball>() : unit_in<Interval>();
    // Doubles serve only far from overflow and underflow (false for NaN too).
    if (judgement_.smallest > -200 && judgement_.largest < 200) {
      judge_hits(filtered_verdict(), unit, claimed);
    } else {
      judge_hits(*verdict_in<Ring>(), unit_in<Ring>(), claimed);
    }
    return judgement_;
  }

 private:
  template <class R>
  const SphereEquation<R>& scene() {
    auto& made = std::get<std::optional<SphereEquation<R>>>(scenes_);
    if (!made) made.emplace(question_, sphere_);
    return *made;
  }

  template <class R>
  std::optional<Truth> verdict_in() {
    return verdict(scene<R>(), question_.ray);
  }
  Truth filtered_verdict() {
    if (const auto truth = verdict_in<Interval>()) return *truth;
    if (const auto truth = verdict_in<Ball>()) return *truth;
    if (const auto truth = verdict_in<Pair>()) return *truth;
    return *verdict_in<Ring>();
  }

  /// The contract's unit of length, in the scale of the equation; notes the sizes.
  template <class R>
  NumberOf<R> unit_in() {
    using Number = NumberOf<R>;
    const SphereSizes<Number> sizes = sizes_of(scene<R>(), question_, sphere_);
    judgement_.far = Number(0) < sizes.radius ? value(sizes.size / sizes.radius) : HUGE_VAL;
    judgement_.smallest = log2_of(sizes.smallest);
    judgement_.largest = log2_of(sizes.largest);
    return sizes.size * sizes.condition * Number(unit_roundoff(precision_));
  }

  template <class Number>
  void judge_hits(const Truth& truth, const Number& unit, const RayAnswer& claimed) {
    judgement_.hit = truth.count() > 0;
    judgement_.wrong = is_wrong_count(truth.count(), claimed);
    for (std::size_t i = 0; i < claimed.hits.count; ++i) {
      const double t = claimed.hits.t[i];
      const HitError error = error_of(truth, unit, truth.side(i), t);
      note_error(judgement_, precision_, t, error.ulp, [&] { return error.residual; });
    }
    if (!judgement_.wrong) return;
    judgement_.ulp = std::nan("");
    if (!truth.is_tangent)  // any change of the radius changes a tangent's verdict
      judgement_.margin = value(distance_to_other_verdict(scene<Ring>(), question_.ray) / Scaled(unit));
  }

  HitError error_of(const Truth& truth, double unit, int side, double t) {
    if (std::isfinite(t)) {
      const auto error = hit_error(scene<Ball>(), truth, unit, side, t, precision_);
      if (error) return *error;
    }
    return error_of(truth, Scaled(unit), side, t);
  }
  /// The same exactly.
  HitError error_of(const Truth&, const Scaled& unit, int side, double t) {
    const RootList roots = roots_of(scene<Ring>());
    const double ulp =
        roots.empty() ? HUGE_VAL : error_in_ulps(side < 0 ? roots.front() : roots.back(), t, precision_);
    if (!std::isfinite(t)) return {ulp, HUGE_VAL};
    return {ulp, value(distance_of(approximate(scene<Ring>().at(t).power), scene<Ring>()) / unit)};
  }

  const RayQuestion& question_;
  const Sphere<double>& sphere_;
  Precision precision_;
  std::tuple<std::optional<SphereEquation<Interval>>, std::optional<SphereEquation<Ball>>,
             std::optional<SphereEquation<Pair>>, std::optional<SphereEquation<Ring>>>
      scenes_;
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
