#pragma once
/// \file
/// The triangle, and the meaning of a ray/triangle method's answers.

#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// The closed triangle a b c: edges and vertices belong to it, from either side. Its normal is (b-a)×(c-a).
///
/// Units of the contracts. Let E be the product of the lengths of its two longest edges, P the largest of
/// |a|, |b|, |c|, and L(t) = |origin| + P + |t||direction|. *Residual* is the distance of p(t) from the
/// triangle's plane: |normal·(p(t) - a)| / (ε·E·L(t)). *Verdict* is the least distance of the ray from an
/// edge of the triangle, or of an end of its interval from the triangle, in units of ε·L(t) where it is
/// nearest; of a bound with a `far_power` p in units of ε·L(t)/s^p, where s = |normal·direction| /
/// (E·|direction|), the *steepness*, is small for a thin triangle and for one seen edge-on. *Ulp* is in ulps
/// of the exact t. *Domain* speaks of all numbers of the case that are not 0.
template <class T>
struct Triangle {
  vec3<T> a, b, c;
};

/// The same triangle in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Triangle<To> convert(const Triangle<From>& t) {
  return {convert<To>(t.a), convert<To>(t.b), convert<To>(t.c)};
}

/// The bound, in the units above, that a robust ray/triangle method keeps (Claim::robust).
inline constexpr double triangle_robust_bound = 4;
/// That of the verdict, with `far_power` 1, of methods that divide by a volume or an area. Guided search
/// comes nearer to it than random cases do (docs/worst-cases.md).
inline constexpr double triangle_divided_bound = 8;

/// Why the methods that divide by a volume or an area do not keep it.
inline constexpr const char* triangle_divisor_vanishes =
    "what is divided by is small beside its rounding where a triangle is thin or seen edge-on";

/// What every sound method says of its first hit. For the normal K = E / |normal|: to round the two edges
/// turns it by 2ε·K, their cross product by 2.31ε·K, to make it a unit vector by ε. For the coordinates K = 1
/// + M²|direction| / |normal·direction|, with M the largest distance of a vertex from the ray's origin, under
/// a transform S.
inline constexpr HitBounds triangle_hit_bounds{.point = {.measured = 2, .promised = 2, .is_proven = true},
                                               .normal = {.measured = 4.01, .promised = 6},
                                               .coordinates = {.measured = 4.68, .promised = 8}};

}  // namespace rayproof
