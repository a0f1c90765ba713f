#pragma once
#include <rayproof/formulas/expanded_quadratic.hpp>
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/sphere.hpp>
#include <rayproof/sphere/centred.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// The textbook's formula with nothing rounded before the square root: a, b, c and the discriminant are exact
/// expansions in double, so the verdict is the exact one and every t is within 0.54 ulp, grazing rays
/// included.
///
/// A ray in float is first answered by Centred in double, whose answer stands where it is clear of every
/// rounding; the expansions decide the rest. An answer is never rounded across an end of the ray's interval.
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±200, beyond which
/// terms of the expansions over- or underflow.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "exact discriminant by expansions";
  static constexpr Source source = sources::shewchuk;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 1.0, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 0.54},
      .hit = sphere_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 200, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp}};

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    if constexpr (sizeof(T) < sizeof(double)) {
      const Ray<double> wide_ray = convert<double>(ray);
      const Sphere<double> wide_sphere = convert<double>(sphere);
      const Roots<double> wide = Centred::roots(wide_ray, wide_sphere);
      if (is_clear<T>(wide_ray, wide_sphere, wide)) {
        return {T(wide.discriminant > 0 ? 1 : -1), T(wide.lo), T(wide.hi)};
      }
    }
    return exact_roots(ray, sphere);
  }

  /// The same by expansions alone, every t rounded once.
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> exact_roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    return roots_of_exact(ray, exact_vector<double>(ray.origin) - exact_vector<double>(sphere.center),
                          exact_vector<double>(ray.direction), exact(static_cast<double>(sphere.radius)));
  }

  /// f points from the centre to the ray's origin, d is its direction and r the radius, all three times one
  /// number of any size that is not 0.
  template <std::floating_point T, class Offset, class Direction, class Radius>
  [[nodiscard]] static Roots<T> roots_of_exact(const Ray<T>& ray, const Vec3<Offset>& f,
                                               const Vec3<Direction>& d, const Radius& r) {
    step<T>(
        "Form the coefficients and the discriminant exactly",
        "An expansion is an exact sum of doubles, so the sign of D, which decides hit or miss, is exact.");
    const auto a = dot(d, d);
    const auto b = -dot(f, d);
    const auto c = dot(f, f) - r * r;
    const auto discriminant = b * b - a * c;
    const double D = estimate(discriminant);
    constexpr T nan = not_a_number<T>;
    if (!(D >= 0 && sign(a) > 0)) return {D < 0 ? T(-1) : nan, nan, nan};

    step<T>(steps::roots_by_viete);
    const double s = sqrt(D);
    const double q = estimate(b) + copysign(s, estimate(b));
    const double t1 = q / estimate(a);
    const double t0 = q == 0 ? q : estimate(c) / q;
    const ExpandedQuadratic equation{a, b, c, s, std::array{min(t0, t1), max(t0, t1)}};

    step<T>("Round each root to its own side of the interval's ends",
            "Each root is compared exactly with t_min and t_max, so rounding cannot move it into the "
            "interval or out of it.");
    return {T(sign(discriminant)), equation.root(ray, -1), equation.root(ray, 1)};
  }

 private:
  /// Whether double rounding errors can't have touched the verdict or moved a root by more than 2^-5 float
  /// ulps.
  ///
  /// With E = (r + |l|)·(|f| + r), Centred's D is off by at most 2^-49·E, which moves a root by less than
  /// 2^-50·E/D of the larger root, and the middle t_c is off by at most 2^-51·(|f| + r)/|d|. That is little
  /// of the smaller root, too, where it keeps 2^-20·E/D of the larger one: this is no less than √D/|d|, and
  /// √D no more than r, so that the smaller one is at least 2^-20·(|f| + r)/|d|. SS is at least (|f| + r)²
  /// and EE at least E².
  template <class T>
  static bool is_clear(const Ray<double>& ray, const Sphere<double>& sphere, const Roots<double>& wide) {
    const glm::dvec3 f = ray.origin - sphere.center;
    const double D = wide.discriminant;
    const double rr = sphere.radius * sphere.radius;
    const double SS = 2 * (dot(f, f) + rr);
    const double EE = 2 * (rr + (rr - D)) * SS;
    const double smaller = min(abs(wide.lo), abs(wide.hi));
    const double larger = max(abs(wide.lo), abs(wide.hi));
    const double kept = D < 0 ? D : D * (smaller / larger);
    if (!(kept * kept > 0x1p-40 * EE)) return false;  // not for a point touched: 0 > 0
    return D < 0 || (is_clear_of_ends<T>(ray, wide.lo) && is_clear_of_ends<T>(ray, wide.hi));
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
