/// \file
/// The judge for ray and sphere. Every formula stands here once, over a ring R; it runs over Interval and
/// Ball, which know when they can't tell, and then over the exact Ring, which always can.

#include <algorithm>

#include "oracle/ball.hpp"
#include "oracle/interval.hpp"
#include "oracle/rounding.hpp"
#include "oracle/sphere.hpp"
#include "oracle/sphere_equation.hpp"

namespace rayproof::oracle {
namespace {

std::optional<int> certain_sign(const Ring& x) { return sign(x); }

/// Numbers to read values by: doubles for balls, which are used only where doubles do not overflow.
double read(const Ball& x) { return x.high; }
Scaled read(const Ring& x) { return approximate(x); }
double value(double x) { return x; }
double value(const Scaled& x) { return static_cast<double>(x.value()); }
using std::abs, std::sqrt;

/// How far the true value of `x` may lie from read(x).
double uncertainty(const Ball& x) { return x.radius; }
double uncertainty(const Ring&) { return 0; }

/// The sign of (root - t) for the root on `side`, from the signs at t; a > 0.
int compare(int side, int power, int slope) {
  if (power < 0) return side;
  if (power > 0) return slope > 0 ? -1 : 1;
  return slope * side >= 0 ? 0 : side;
}

/// Which roots lie in the ray's interval.
struct Truth {
  bool lower = false;
  bool upper = false;
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(lower) + static_cast<std::size_t>(upper);
  }
};

/// The exact verdict, or nothing where R can't tell.
template <class R>
std::optional<Truth> verdict(const SphereEquation<R>& scene, const Ray<double>& ray) {
  const R a = scene.a(), h = scene.h(), c = scene.c();
  const auto discriminant = certain_sign(h * h - a * c);
  if (!discriminant) return std::nullopt;
  if (*discriminant < 0) return Truth{};
  Truth truth{true, *discriminant > 0};
  for (const auto& [end, inside] : {std::pair{ray.t_min, 1}, std::pair{ray.t_max, -1}}) {
    if (std::isinf(end)) continue;
    const PowerAt<R> at = end == 0 ? PowerAt<R>{c, h} : scene.at(end);
    const auto power = certain_sign(at.power);
    const auto slope = certain_sign(at.slope);
    if (!power || !slope) return std::nullopt;
    truth.lower = truth.lower && compare(-1, *power, *slope) * inside >= 0;
    truth.upper = truth.upper && compare(1, *power, *slope) * inside >= 0;
  }
  return truth;
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
  const auto norm = [](const Vector<R>& v) { return sqrt(abs(read(dot(v, v)))); };
  using Number = decltype(norm(scene.direction));
  const Number radius = abs(read(scene.radius));
  const Number direction = norm(Vector<R>::from(question.ray.direction));
  if (!ray.map) {
    const Number size = norm(scene.from_center) + radius;
    return Lengths<Number>{size, radius, Number(1), std::min(size, direction), std::max(size, direction)};
  }
  const auto& m = *question.transform;
  const auto frobenius = [&](const Vector<R>& x, const Vector<R>& y, const Vector<R>& z) {
    return sqrt(read(dot(x, x)) + read(dot(y, y)) + read(dot(z, z)));
  };
  const Number scale = abs(read(ray.scale));
  const Number forward = frobenius(Vector<R>::from(m[0]), Vector<R>::from(m[1]), Vector<R>::from(m[2]));
  const Number backward = frobenius(ray.map->row_x, ray.map->row_y, ray.map->row_z);  // times the determinant
  const Number to_origin = norm(Vector<R>::from(question.ray.origin)) + norm(ray.map->translation);
  const Number size = backward * to_origin + scale * norm(Vector<R>::from(sphere.center)) + radius;
  const auto all = {size / scale, direction, forward, scale / backward, norm(scene.direction) / scale};
  return Lengths<Number>{size, radius, forward * backward / scale, std::min(all), std::max(all)};
}

/// The error of a claimed t against the root on `side`, and the distance of p(t) from the surface in units of
/// `unit`.
struct HitError {
  double ulp;
  double residual;
};

/// The error of a finite t; nothing where R can't tell.
template <class R, class Unit>
std::optional<HitError> hit_error(const SphereEquation<R>& scene, const Unit& unit, int side, double t,
                                  Precision precision) {
  const PowerAt<R> at = scene.at(t);
  const R a = scene.a();
  const R discriminant = at.slope * at.slope - a * at.power;
  const auto power = read(at.power);
  const auto D = read(discriminant);
  using Number = std::remove_cvref_t<decltype(power)>;
  if (uncertainty(discriminant) > 0x1p-20 * abs(value(D))) return std::nullopt;

  const Number w = sqrt(abs(D));
  const Number u = side > 0 ? read(at.slope) : -read(at.slope);
  const Number sum = abs(u) + w;
  Number to_root{0};
  if (Number(0) < u) {
    to_root = (side > 0 ? -power : power) / sum;
  } else if (Number(0) < sum) {
    to_root = (side > 0 ? w - u : u - w) / read(a);
  }
  const double error = value(to_root);
  const double ulp = ulp_of(t + error, precision);
  const double doubt = uncertainty(at.power) == 0 ? 0 : uncertainty(at.power) / value(sum);
  if (doubt > std::max(0x1p-20 * abs(error), 0x1p-30 * ulp)) return std::nullopt;

  const Number radius = abs(read(scene.radius));
  const Number distance = sqrt(abs(power + radius * radius));
  const Number off_surface = abs(power) / (distance + radius);
  return HitError{abs(error) / ulp, value(off_surface / unit)};
}

/// How much the radius must change for another verdict, in the scale of the equation.
Scaled distance_to_other_verdict(const SphereEquation<Ring>& scene, const Ray<double>& ray) {
  const Scaled radius = abs(approximate(scene.radius));
  const auto change = [&](const Scaled& power) {
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

/// Everything the judge derives from a case in one ring.
template <class R>
struct Bench {
  ObjectRay<R> ray;
  SphereEquation<R> scene;

  Bench(const RayQuestion& question, const Sphere<double>& sphere) : ray(question), scene(ray, sphere) {}
};

Truth exact_verdict(const RayQuestion& question, const Sphere<double>& sphere, const Bench<Ball>& ball) {
  if (const auto truth = verdict(Bench<Interval>(question, sphere).scene, question.ray)) return *truth;
  if (const auto truth = verdict(ball.scene, question.ray)) return *truth;
  return *verdict(Bench<Ring>(question, sphere).scene, question.ray);
}

/// The error of an infinite or NaN t: right only where the exact root rounds to the same infinity.
HitError infinite_hit_error(const SphereEquation<Ring>& scene, int side, double t, Precision precision) {
  const ExactRoot root({scene.a(), scene.h(), scene.c()}, side);
  const bool right = round_correctly(root, precision) == t;
  return right ? HitError{0, 0} : HitError{HUGE_VAL, HUGE_VAL};
}

double log2_of(double x) { return std::log2(x); }
double log2_of(const Scaled& x) { return x.sign() == 0 ? -HUGE_VAL : static_cast<double>(x.exponent() - 1); }

template <class Number>
void note_lengths(const Lengths<Number>& lengths, Judgement& judgement) {
  judgement.far = Number(0) < lengths.radius ? value(lengths.size / lengths.radius) : HUGE_VAL;
  judgement.smallest = log2_of(lengths.smallest);
  judgement.largest = log2_of(lengths.largest);
}

/// Judges the claimed hits in one ring; nothing where it can't tell.
template <class R>
bool judge_hits(const Bench<R>& bench, const RayQuestion& question, const Sphere<double>& sphere,
                Precision precision, const Truth& truth, const HitList& hits, Judgement& judgement) {
  const auto sizes = lengths(bench.scene, bench.ray, question, sphere);
  note_lengths(sizes, judgement);
  using Number = decltype(sizes.size);
  // Doubles serve only far from overflow and underflow (false for NaN too).
  const bool moderate = judgement.smallest > -200 && judgement.largest < 200;
  if (std::is_same_v<R, Ball> && !moderate) return false;

  const Number unit = sizes.size * sizes.condition * Number(unit_roundoff(precision));
  const double tiny = precision == Precision::float32 ? 0x1p-126 : 0x1p-1022;
  judgement.ulp = judgement.residual = 0;
  for (std::size_t i = 0; i < hits.count; ++i) {
    const int side = i > 0 || !truth.lower ? 1 : -1;
    const double t = hits.t.at(i);
    const auto error = std::isfinite(t)
                           ? hit_error(bench.scene, unit, side, t, precision)
                           : infinite_hit_error(Bench<Ring>(question, sphere).scene, side, t, precision);
    if (!error) return false;
    judgement.ulp = std::max(judgement.ulp, error->ulp);
    // Where the grid of floats itself is coarse or ends, the nearest float is all that can be asked for.
    const bool grid_ends = !std::isfinite(t) || std::abs(t) < tiny;
    if (!(grid_ends && error->ulp <= 1)) judgement.residual = std::max(judgement.residual, error->residual);
  }
  if (judgement.wrong) {
    judgement.ulp = std::nan("");
    const Bench<Ring> exact(question, sphere);
    const auto exact_sizes = lengths(exact.scene, exact.ray, question, sphere);
    const Scaled exact_unit = exact_sizes.size * exact_sizes.condition * Scaled(unit_roundoff(precision));
    judgement.margin = value(distance_to_other_verdict(exact.scene, question.ray) / exact_unit);
  }
  return true;
}

}  // namespace

Judgement judge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision,
                const RayAnswer& claimed) {
  const Bench<Ball> ball(question, sphere);
  const Truth truth = exact_verdict(question, sphere, ball);
  Judgement judgement;
  judgement.hit = truth.count() > 0;
  const std::size_t expected = claimed.nearest_only ? std::min<std::size_t>(truth.count(), 1) : truth.count();
  judgement.wrong = expected != claimed.hits.count;
  if (!judge_hits(ball, question, sphere, precision, truth, claimed.hits, judgement)) {
    judge_hits(Bench<Ring>(question, sphere), question, sphere, precision, truth, claimed.hits, judgement);
  }
  return judgement;
}

}  // namespace rayproof::oracle
