#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/plane/forms.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The solution of point + a·u + b·v = o + t·d, and the determinant of the system; all NaN or infinite where
/// the determinant is 0.
template <class T>
struct Meeting {
  T determinant;
  T t;
  T a;
  T b;
};

/// Cramer's rule on the 3×3 system with the columns u, v, d and the unknowns a, b, -t.
template <class T>
[[nodiscard]] constexpr Meeting<T> meet_by_cramer(const Ray<T>& ray, const vec3<T>& point, const vec3<T>& u,
                                                  const vec3<T>& v) {
  step<T>(
      "Form the determinant of u, v and the direction",
      "α·u + β·v − t·d = w is three equations for α, β and t; w leads from the plane's point to the ray's "
      "origin. D is the signed volume that u, v and d span: 0 where the ray is parallel to the plane.");
  const vec3<T> w = named("w", ray.origin - point);
  const vec3<T> d = ray.direction;
  const vec3<T> n = named("u×v", cross(u, v));
  const T D = named("D", dot(n, d));

  step<T>("Put w in the place of each column in turn",
          "Cramer's rule: each unknown is a quotient of two volumes. The column d belongs to −t, so t = −D_t "
          "/ D.");
  const vec3<T> wv = named("w×v", cross(w, v));
  const vec3<T> uw = named("u×w", cross(u, w));
  const T D_a = named("D_α", dot(wv, d));
  const T D_b = named("D_β", dot(uw, d));
  const T D_t = named("D_t", dot(n, w));
  return {D, named("t", -D_t / D), named("α", D_a / D), named("β", D_b / D)};
}

/// point + a·u + b·v = o + t·d, solved by Cramer's rule; the answer's u and v are a and b where the plane is
/// given in the parametric form, else 0.
///
/// A ray whose direction u and v span is parallel to the plane or runs inside it: a miss.
struct ByParameters {
  static constexpr const char* name = "parametric";
  static constexpr const char* title = "a system of three equations by Cramer's rule";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .verdict = {.measured = 2.18, .promised = plane_robust_bound, .is_proven = true},
      .residual = {.measured = 4.47, .promised = plane_robust_bound, .is_proven = true},
      .hit = plane_hit_bounds,
      .holds = robust_claims | hit_claims | Claims{Claim::coordinates, Claim::residual, Claim::bounded}};
  static constexpr bool has_parameters = true;  ///< the answer's u and v say where on the plane the hit is

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    const auto [point, u, v] = as_parametric(plane);
    const auto [D, t, a, b] = meet_by_cramer(ray, point, u, v);
    const bool is_parametric = plane.form == PlaneForm::parametric;
    return flat_hit(D != T(0), t, is_parametric ? a : T(0), is_parametric ? b : T(0));
  }
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
