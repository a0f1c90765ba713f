/// \file
/// The oracle for ray and sphere. It judges by the cheapest arithmetic that is certain.

#include <tuple>

#include "oracle/numbers/fused.hpp"
#include "oracle/shapes/shapes.hpp"
#include "oracle/shapes/sphere/equation.hpp"

namespace rayproof::oracle {
namespace {

class SphereIntersection final : public ExactIntersection {
 public:
  SphereIntersection(const RayQuestion& question, const Sphere<double>& sphere)
      : ExactIntersection(question), sphere_(sphere), scene_(ray(), sphere) {}

  [[nodiscard]] ExactContacts hits() const override {
    ExactContacts all;
    RootList roots = real_roots(quadratic());
    const Contact contact = roots.size() == 1 ? Contact::tangent : Contact::crossing;
    for (ExactRoot& t : roots) add(all, std::move(t), contact);
    return all;
  }

  /// None of a point, which is a sphere of radius 0.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact&) const override {
    if (sign(scene_.radius) == 0) return std::nullopt;
    return ExactNormal{scene_.from_center, scene_.ray.direction};
  }

  [[nodiscard]] ExactQuadratic quadratic() const { return {scene_.a(), scene_.h(), scene_.c()}; }
  [[nodiscard]] const SphereSizes<Scaled>& sizes() const {
    if (!sizes_) sizes_ = sizes_of(scene_, question(), sphere_);
    return *sizes_;
  }

  /// How far p(t) is from the surface, in the scale of the equation.
  [[nodiscard]] Scaled distance_at(const Quotient& t) const {
    const Ring& weight = t.denominator();
    const Vector<Ring> p = from_center_at(t);
    const Ring radius = weight * scene_.radius;
    return distance(approximate(dot(p, p) - radius * radius) / approximate(weight * weight));
  }
  /// How much the radius must change for another verdict, in the scale of the equation.
  [[nodiscard]] Scaled distance_to_other_verdict() const {
    const ExactQuadratic q = quadratic();
    const Ray<double>& ray = question().ray;
    Scaled nearest = endless();
    // The line touches a sphere whose squared radius is larger by -D/a: the power of its nearest point. Of
    // the ray that is a change only where its interval holds that point.
    if (is_in_interval(Quotient(-q.h, q.a), ray.t_min, ray.t_max))
      nearest = distance(-approximate(q.discriminant()) / approximate(q.a));
    for (const double end : finite_ends(question().ray)) reduce(nearest, distance_at(end));
    return nearest;
  }
  [[nodiscard]] Scaled residual(const Quotient& t) const override { return distance_at(t) / sizes().unit; }
  [[nodiscard]] Scaled off_surface(const Vector<Ring>& point, const Quotient& t) const override {
    const Vector<Ring> p = scene_.from_center + (point - scene_.ray.origin);
    const Scaled apart = distance(approximate(dot(p, p) - scene_.radius * scene_.radius));
    const Scaled scale = approximate(scene_.ray.scale), radius = abs(approximate(scene_.radius));
    return ratio(apart, scale * (reach(t) + norm(sphere_.center)) + radius);
  }
  [[nodiscard]] SurfaceParts parts(const Quotient& t, const Scaled& /*roundoff*/) const override {
    SurfaceParts whole;
    const Scaled from_center = norm(from_center_at(t)) / approximate(t.denominator());
    if (sign(scene_.radius) == 0 || from_center.sign() == 0) return whole;
    const Scaled condition = Scaled(1) + approximate(scene_.ray.scale) * reach(t) / from_center;
    whole.push_back({{scene_.from_center, scene_.ray.direction}, {}, condition});
    return whole;
  }
  [[nodiscard]] Scaled margin(bool) const override {
    return ratio(distance_to_other_verdict(), sizes().unit);
  }
  [[nodiscard]] double far() const override { return sizes().far; }

 private:
  /// L(t), of the ray alone.
  [[nodiscard]] Scaled reach(const Quotient& t) const {
    const RaySizes<Ring> of_ray(question(), ray());
    return of_ray.origin + abs(t.estimate()) * of_ray.direction;
  }
  /// p(t) as seen from the centre, in the scale of the equation and times the denominator of t.
  [[nodiscard]] Vector<Ring> from_center_at(const Quotient& t) const {
    return t.denominator() * scene_.from_center + t.numerator() * scene_.ray.direction;
  }
  /// The distance of a point of this power.
  [[nodiscard]] Scaled distance(const Scaled& power) const {
    if (power.sign() == 0) return {};  // a point has no radius to divide by
    return abs(power) / far_side(power, abs(approximate(scene_.radius)));
  }

  const Sphere<double>& sphere_;
  SphereEquation<Ring> scene_;
  mutable std::optional<SphereSizes<Scaled>> sizes_;
};

/// The judgement of one case. A ring's equation is made only when it is asked for: that of the estimates for
/// the error of a hit, the exact one when no filter could decide.
class SphereJudge {
 public:
  SphereJudge(const RayQuestion& question, const Sphere<double>& sphere)
      : question_(question), sphere_(sphere) {}

  Judgement judge(Precision precision, const RayAnswer& claimed) {
    // Without a transform one subtraction makes a coordinate, so that estimates would have the same sizes.
    const SphereSizes<double> sizes = question_.transform ? sizes_of(scene<Estimate>(), question_, sphere_)
                                                          : sizes_of(scene<Interval>(), question_, sphere_);
    // Doubles serve only far from overflow and underflow (false for NaN too).
    if (!(sizes.smallest > -200 && sizes.largest < 200)) return judge_exactly(precision, claimed);
    const Truth truth = filtered_verdict();
    Judgement judgement{.wrong = is_wrong_count(truth.count(), claimed),
                        .hit = truth.count() > 0,
                        .far = sizes.far,
                        .smallest = sizes.smallest,
                        .largest = sizes.largest};
    const double unit = sizes.unit * roundoff_of(precision);
    const std::size_t judged = claimed.verdict_only ? 0 : claimed.hits.count;
    for (std::size_t i = 0; i < judged; ++i) {
      const double t = claimed.hits.t[i];
      auto error = hit_error(scene<Estimate>(), truth, unit, truth.side(i), t, precision);
      if (!error) error = exact_error(unit, truth.side(i), t, precision);
      note_error(judgement, precision, t, error->ulp, [&] { return error->residual; });
    }
    if (!judgement.wrong) return judgement;
    judgement.ulp = std::nan("");
    judgement.margin = exact_margin(unit);
    return judgement;
  }

 private:
  template <class R>
  const SphereEquation<R>& scene() {
    auto& made = std::get<std::optional<SphereEquation<R>>>(scenes_);
    if (!made) made.emplace(question_, sphere_);
    return *made;
  }
  Truth filtered_verdict() {
    if (const auto truth = verdict(scene<Interval>(), question_.ray)) return *truth;
    if (const auto truth = verdict(scene<Estimate>(), question_.ray)) return *truth;
    if (const auto truth = verdict(scene<Pair>(), question_.ray)) return *truth;
    return exact_verdict();
  }

  // What is rarely wanted stays out of line: inlined, it costs every judgement a twentieth.
  [[gnu::noinline]] Truth exact_verdict() const {
    return *verdict(SphereEquation<Ring>(question_, sphere_), question_.ray);
  }
  [[gnu::noinline]] double exact_margin(double unit) const {
    return value(SphereIntersection(question_, sphere_).distance_to_other_verdict() / Scaled(unit));
  }
  [[gnu::noinline]] HitError exact_error(double unit, int side, double t, Precision precision) const {
    const SphereIntersection exact(question_, sphere_);
    const RootList roots = real_roots(exact.quadratic());
    const auto ulps = [&](const ExactRoot& root) { return error_in_ulps(root, t, precision); };
    return {roots.empty() ? HUGE_VAL : ulps(side < 0 ? roots.front() : roots.back()),
            std::isfinite(t) ? value(exact.distance_at(t) / Scaled(unit)) : HUGE_VAL};
  }
  [[gnu::noinline]] Judgement judge_exactly(Precision precision, const RayAnswer& claimed) const {
    const SphereIntersection exact(question_, sphere_);
    Judgement judgement = oracle::judge(exact, precision, claimed);
    judgement.smallest = exact.sizes().smallest;
    judgement.largest = exact.sizes().largest;
    return judgement;
  }

  const RayQuestion& question_;
  const Sphere<double>& sphere_;
  std::tuple<std::optional<SphereEquation<Interval>>, std::optional<SphereEquation<Estimate>>,
             std::optional<SphereEquation<Pair>>>
      scenes_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Sphere<double>& sphere) {
  return std::make_unique<SphereIntersection>(question, sphere);
}

Judgement judge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision,
                const RayAnswer& claimed) {
  return with_fused_products([&] { return SphereJudge(question, sphere).judge(precision, claimed); });
}

}  // namespace rayproof::oracle
