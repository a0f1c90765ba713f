#pragma once
/// \file
/// The sphere, and the meaning of a ray/sphere method's answers.

#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// All points at distance `radius` from `center`; a radius of 0 makes it a point.
///
/// Units of the contracts. Let S = |origin - center| + radius, the size of the scene as the ray sees it, and
/// ε the unit roundoff (2^-24 in float, 2^-53 in double). *Verdict* and *residual* are lengths in units of
/// ε·S·(S/radius)^p with p = `far_power` of the bound: a verdict may be wrong only
/// where a sphere whose radius differs by that length has the other verdict, and every hit p(t) is within
/// that length of the surface. *Ulp* is in ulps of the exact t. *Domain* speaks of S and of |direction|.
/// Under a transform, lengths are measured in the sphere's own space, the unit grows by the transform's
/// condition number, no ulp is promised, and a method that promises less than `sphere_robust_bound` promises
/// just that: the ray has been rounded before the method sees it.
template <class T>
struct Sphere {
  vec3<T> center;
  T radius;
};

/// The same sphere in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Sphere<To> convert(const Sphere<From>& sphere) {
  return {convert<To>(sphere.center), To(sphere.radius)};
}

/// The outward unit normal at a point of the sphere; NaN at the centre, where the point of a tiny one may be
/// rounded to.
template <class T>
[[nodiscard]] vec3<T> normal_at(const Sphere<T>& sphere, const vec3<T>& point) {
  return unit_vector<T>(point - sphere.center);
}

/// The bound, in the units above with p = 0, that a robust ray/sphere method keeps (Claim::robust): what is
/// proven of `centred`, which has the proof.
inline constexpr double sphere_robust_bound = 18;

/// What every sound method says of its first hit. K = 1 + (|origin| + |t||direction|)/|p(t) - center|, as |p|
/// over the radius: the point's rounding, seen from the centre.
inline constexpr HitBounds sphere_hit_bounds{.point = {.measured = 2, .promised = 2, .is_proven = true},
                                             .normal = {.measured = 3.37, .promised = 5}};

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
