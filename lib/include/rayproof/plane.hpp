#pragma once
/// \file
/// The plane in its three forms, and the meaning of a ray/plane method's answers.

#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// How a plane is given.
enum class PlaneForm {
  implicit,      ///< normal·q + d = 0
  point_normal,  ///< normal·(q - point) = 0
  parametric     ///< q = point + a·u + b·v
};

/// A plane in one of its forms; the members that the form does not speak of are not looked at.
///
/// Units of the contracts. Let N = |normal| (|u||v| in the parametric form), P = |d|/|normal| or |point|, and
/// L(t) = |origin| + P + |t||direction|. *Residual* is the distance of p(t) from the plane, seen through the
/// form's numbers: |n·(p(t) - point)| / (ε·N·L(t)). *Verdict* is the least of the same at the ends of the
/// ray's interval and of |n·direction| / (ε·N·|direction|): how near the ray is to an end of its interval or
/// to being parallel. *Ulp* is in ulps of the exact t. *Domain* speaks of all numbers of the case that are
/// not 0.
template <class T>
struct Plane {
  PlaneForm form;
  vec3<T> point;
  vec3<T> normal;
  T d;
  vec3<T> u, v;
};

/// The same plane in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Plane<To> convert(const Plane<From>& p) {
  return {p.form, convert<To>(p.point), convert<To>(p.normal), To(p.d), convert<To>(p.u), convert<To>(p.v)};
}

/// The bound, in the units above, that a robust ray/plane method keeps (Claim::robust), verdict and residual.
///
/// It is proven, but for terms in ε². In units of ε·N: a cross product is off by 2.31|u||v|, a dot product by
/// 3 times the lengths, so that o - p, two dot products and the quotient come to 4·L(t). A normal that is u ×
/// v adds 2.31·L(t). The point of an implicit plane is off by 5·P along the normal, and P is no more than
/// half of L(t) where t is the hit: 2.5·L(t). Two vectors that span a given normal turn it by 4.62: 11.1 in
/// all.
inline constexpr double plane_robust_bound = 12;

/// What every sound method says of its first hit. For the normal K is 1 where one is given, and else
/// |u||v| / |u×v|. For the coordinates α, β of a parametric plane's hit, point + α·u + β·v, which
/// `parametric` gives, K = (|origin - point| + |α||u| + |β||v|)·max(|u|, |v|)·|direction| / |n·direction|,
/// where |n·direction| counts less its own rounding, 6ε|u||v||direction| (under a transform 24ε): where that
/// leaves nothing the coordinates may be anything. By the errors above the volumes are off by 6.31ε times
/// their lengths, and the quotient by 6.31ε·K and its own ε.
inline constexpr HitBounds plane_hit_bounds{.point = {.measured = 2, .promised = 2, .is_proven = true},
                                            .normal = {.measured = 3.26, .promised = 5},
                                            .coordinates = {.measured = 2.68, .promised = 8}};

}  // namespace rayproof
