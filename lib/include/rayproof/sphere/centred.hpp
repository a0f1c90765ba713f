#pragma once
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/sphere.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// The discriminant as geometry: r² less the squared distance of the centre from the line, formed at the ray
/// point nearest the centre; then half a chord to either side of that point.
///
/// As good far away as near by, since nothing as large as |f|² is ever squared and subtracted. The cost is
/// one division and one square root. Departs from its source in the roots: the source takes c/q from Viète,
/// which for an origin beside the tangent point divides a rounded c by a q that is all rounding, and can be
/// wrong without bound.
///
/// The bounds are proven but for terms in ε times a bound, in units of ε·S. To round f moves the centre by 1.
/// t_c is off by 8 along the ray: the dot product by 3, d·d by 3, its inverse by 1, the product by 1. l is
/// off by that and, in any direction, by 2; the roundings of its square and of r² come to 1.5 of |l| and 1 of
/// r. So D is r'² - |l'|² with r' off by 1 and |l'| by 8 + 3.5, and a verdict by 13.5. Of a hit, where e is
/// the 8, p(t) is at the distance √(r'² ± 2e√(r'² - e²)) from the centre: off by √2·e where r' is no more
/// than that, and by 1 + 1 + 3.5 as before and 1 for the last sum: 17.8 in all. Of a larger sphere that e is
/// hardly more than 8, and as much less as the roundings of h, 3.5 of r, come to.
///
/// The domain in float is a little smaller than usual: where a miss may not be called a hit, D is -(18ε·S)²
/// or less, and D/a must not underflow to 0, whose root is no NaN.
struct Centred {
  static constexpr const char* name = "centred";
  static constexpr const char* title = "discriminant from the ray point nearest the centre";
  static constexpr Source source = sources::haines_2019;
  static constexpr Contract contract{
      .verdict = {.measured = 4.97, .promised = sphere_robust_bound, .is_proven = true},
      .residual = {.measured = 8.31, .promised = sphere_robust_bound, .is_proven = true},
      .hit = sphere_hit_bounds,
      .domain = {.reach_float = 26},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::bounded}};

  /// What a sphere cuts out of a line: about t_c a length in t whose half, squared, is D·per_a.
  template <class T>
  struct CutOut {
    T t_c, D, per_a;
  };

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    const auto [t_c, D, per_a] = cut_out(ray, sphere);
    return ends_of_chord(t_c, D, per_a);
  }

  template <class T>
  [[nodiscard]] static constexpr CutOut<T> cut_out(const Ray<T>& ray, const Sphere<T>& sphere) {
    step<T>("Measure the ray from the centre",
            "f points from the centre to o; the sphere's position enters only through it.");
    const vec3<T> f = named("f", ray.origin - sphere.center);
    const vec3<T> d = ray.direction;

    step<T>("Find the ray point nearest the centre",
            "t_c is where the ray comes nearest the centre. l leads from the centre to that point: it is "
            "perpendicular to d, and |l| is the distance of the line from the centre.");
    const T per_a = named("1/a", T(1) / dot(d, d));
    const T t_c = named("t_c", -dot(f, d) * per_a);
    const vec3<T> l = named("l", f + t_c * d);

    step<T>(steps::compare_with_radius);
    const T D = named("D", sphere.radius * sphere.radius - dot(l, l));
    return {t_c, D, per_a};
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
