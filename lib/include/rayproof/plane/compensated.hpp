#pragma once
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/plane.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// Numerator and denominator of t as exact expansions in double, in the plane's own form: the verdict is the
/// exact one, t is rounded once, and no answer is rounded across an end of the ray's interval.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±200, beyond which
/// terms of the expansions over- or underflow.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "exact numerator and denominator by expansions";
  static constexpr Source source = sources::shewchuk;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.5, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 0.51},
      .hit = {plane_hit_bounds.point, plane_hit_bounds.normal},
      .domain = {.reach_float = 1000, .reach_double = 200, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp, Claim::rounded}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    if (!are_finite(ray.origin, ray.direction)) return no_hit<T>;
    switch (plane.form) {
      case PlaneForm::implicit:
        return meet_implicit(ray, plane);
      case PlaneForm::point_normal:
        return meet_point_normal(ray, plane);
      case PlaneForm::parametric:
        return meet_parametric(ray, plane);
    }
    return no_hit<T>;
  }

 private:
  template <class T>
  static FlatHit<T> meet_implicit(const Ray<T>& ray, const Plane<T>& plane) {
    if (!are_finite(plane.normal, plane.d)) return no_hit<T>;
    step<T>("Put the ray into the plane's equation exactly",
            "n·o + d and n·d⃗ are exact, so a parallel ray is recognised with certainty; "
            "t = −(n·o + d) / (n·d⃗) is rounded once.");
    const auto n = exact_vector<double>(plane.normal);
    const auto at_origin = dot(n, exact_vector<double>(ray.origin)) + exact(double{plane.d});
    const auto along = dot(n, exact_vector<double>(ray.direction));
    if (sign(along) == 0) return no_hit<T>;
    return hit_at(rounded(ray, ExactRatio{-at_origin, along}), T(0), T(0));
  }

  template <class T>
  static FlatHit<T> meet_point_normal(const Ray<T>& ray, const Plane<T>& plane) {
    if (!are_finite(plane.normal, plane.point)) return no_hit<T>;
    step<T>("Form the distance to the plane and the ray's progress exactly",
            "n·(p − o) and n·d⃗ are exact, so a parallel ray is recognised with certainty; their quotient t "
            "is rounded once.");
    const auto n = exact_vector<double>(plane.normal);
    const auto w = exact_vector<double>(plane.point) - exact_vector<double>(ray.origin);
    const auto along = dot(n, exact_vector<double>(ray.direction));
    if (sign(along) == 0) return no_hit<T>;
    return hit_at(rounded(ray, ExactRatio{dot(n, w), along}), T(0), T(0));
  }

  template <class T>
  static FlatHit<T> meet_parametric(const Ray<T>& ray, const Plane<T>& plane) {
    if (!are_finite(plane.point, plane.u, plane.v)) return no_hit<T>;
    step<T>(
        "Form the determinants of Cramer's rule exactly",
        "D is the exact volume of u, v and the direction: 0 only where the ray is parallel to the plane.");
    const auto u = exact_vector<double>(plane.u);
    const auto v = exact_vector<double>(plane.v);
    const auto d = exact_vector<double>(ray.direction);
    const auto w = exact_vector<double>(ray.origin) - exact_vector<double>(plane.point);
    const auto n = cross(u, v);
    const auto D = dot(n, d);
    if (sign(D) == 0) return no_hit<T>;

    step<T>(steps::round_quotients);
    return hit_at(rounded(ray, ExactRatio{-dot(n, w), D}),
                  rounded_alone<T>(ExactRatio{dot(cross(v, d), w), D}),
                  rounded_alone<T>(ExactRatio{dot(cross(d, u), w), D}));
  }
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
