#pragma once
#include <rayproof/formulas/bounded_roots.hpp>
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/plane.hpp>
#include <rayproof/plane/correction.hpp>
#include <rayproof/plane/estimated.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// Correctly rounded: the verdict is the exact one, and t the exact t rounded once, ties to even; so are the
/// parameters of a plane in the parametric form, each off by ε of itself at most.
///
/// The plane's own form is solved in double for a ray in float, in double-double for one in double, in packs
/// too (`estimated`); that answer stands where its error bound leaves no doubt of a ray's being parallel and
/// of the rounding, which is nearly everywhere. The rest goes to numerators and denominators without
/// rounding. No answer is rounded across an end of the ray's interval.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±200, beyond which
/// terms of the expansions over- or underflow; under a transform within 2^±24.
struct Rounded {
  static constexpr const char* name = "rounded";
  static constexpr const char* title = "correctly rounded: with more digits, exact where in doubt";
  static constexpr Source source = sources::ziv;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.5, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 0.51},
      .hit = {plane_hit_bounds.point,
              plane_hit_bounds.normal,
              {.measured = 0.992, .promised = 1.01, .is_proven = true}},
      .domain = {.reach_float = 1000, .reach_double = 200, .every_number = true},
      .holds = robust_claims | hit_claims |
               Claims{Claim::coordinates, Claim::residual, Claim::ulp, Claim::rounded, Claim::bounded}};
  static constexpr bool has_parameters = true;  ///< the answer's u and v say where on the plane the hit is

  /// What is tried first where the nearest hit alone is asked for.
  using Correction = plane::Correction;

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    return quick_or_exact_roots<Rounded>(ray, plane);
  }

  template <class W>
  [[nodiscard]] static constexpr EnclosedHit<W> enclosed(const Ray<W>& ray, const Plane<W>& plane) {
    return estimated(ray, plane);
  }

  /// By expansions alone.
  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> exact_roots(const Ray<T>& ray, const Plane<T>& plane) {
    return met_exactly<Rounded>(ray, plane);
  }

  /// The same under a transform.
  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                                 const Plane<T>& plane) {
    return quick_or_exact_roots<Rounded>(space, ray, plane);
  }

  /// The plane's own form met by a ray in object space whose numbers have bounds on their errors.
  template <class W>
  [[nodiscard]] static constexpr EnclosedHit<W> enclosed_in_space(const Ray<Bounded<W>>& ray,
                                                                  const Plane<Bounded<W>>& plane) {
    switch (plane.form) {
      case PlaneForm::implicit:
        return enclosed_by_bounds(ByEquation::roots(ray, plane));
      case PlaneForm::point_normal:
        return enclosed_by_bounds(ByPointAndNormal::roots(ray, plane));
      default:
        return enclosed_by_bounds(ByParameters::roots(ray, plane));
    }
  }

  /// Where a ray from o along d meets the plane, as met_exactly has them.
  template <std::floating_point T, class Number, class Unit>
  [[nodiscard]] static FlatHit<T> meet(const Ray<T>& ray, const Plane<T>& plane, const Vec3<Number>& o,
                                       const Vec3<Number>& d, const Unit& unit) {
    switch (plane.form) {
      case PlaneForm::implicit:
        return meet_implicit(ray, plane, o, d, unit);
      case PlaneForm::point_normal:
        return meet_point_normal(ray, plane, o, d, unit);
      case PlaneForm::parametric:
        return meet_parametric(ray, plane, o, d, unit);
    }
    return no_hit<T>;
  }

 private:
  template <class T, class Number, class Unit>
  static FlatHit<T> meet_implicit(const Ray<T>& ray, const Plane<T>& plane, const Vec3<Number>& o,
                                  const Vec3<Number>& d, const Unit& unit) {
    if (!are_finite(plane.normal, plane.d)) return no_hit<T>;
    step<T>("Put the ray into the plane's equation exactly",
            "n·o + D and n·d are exact, so a parallel ray is recognised with certainty; "
            "t = −(n·o + D) / (n·d) is rounded once.");
    const auto n = exact_vector<double>(plane.normal);
    const auto at_origin = dot(n, o) + unit * exact(double{plane.d});
    const auto along = dot(n, d);
    if (sign(along) == 0) return no_hit<T>;
    return hit_at(rounded(ray, ExactRatio{-at_origin, along}), T(0), T(0));
  }

  template <class T, class Number, class Unit>
  static FlatHit<T> meet_point_normal(const Ray<T>& ray, const Plane<T>& plane, const Vec3<Number>& o,
                                      const Vec3<Number>& d, const Unit& unit) {
    if (!are_finite(plane.normal, plane.point)) return no_hit<T>;
    step<T>("Form the distance to the plane and the ray's progress exactly",
            "n·(p − o) and n·d are exact, so a parallel ray is recognised with certainty; their quotient t "
            "is rounded once.");
    const auto n = exact_vector<double>(plane.normal);
    const auto w = unit * exact_vector<double>(plane.point) - o;
    const auto along = dot(n, d);
    if (sign(along) == 0) return no_hit<T>;
    return hit_at(rounded(ray, ExactRatio{dot(n, w), along}), T(0), T(0));
  }

  template <class T, class Number, class Unit>
  static FlatHit<T> meet_parametric(const Ray<T>& ray, const Plane<T>& plane, const Vec3<Number>& o,
                                    const Vec3<Number>& d, const Unit& unit) {
    if (!are_finite(plane.point, plane.u, plane.v)) return no_hit<T>;
    step<T>(
        "Form the determinants of Cramer's rule exactly",
        "D is the exact volume of u, v and the direction: 0 only where the ray is parallel to the plane.");
    const auto u = exact_vector<double>(plane.u);
    const auto v = exact_vector<double>(plane.v);
    const auto w = o - unit * exact_vector<double>(plane.point);
    const auto n = cross(u, v);
    const auto D = dot(n, d);
    if (sign(D) == 0) return no_hit<T>;

    step<T>(steps::round_quotients);
    return hit_at(rounded(ray, ExactRatio{-dot(n, w), D}),
                  rounded_alone<T>(ExactRatio{dot(cross(v, d), w), unit * D}),
                  rounded_alone<T>(ExactRatio{dot(cross(d, u), w), unit * D}));
  }
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
