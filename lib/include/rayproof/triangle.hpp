#pragma once
/// \file
/// The triangle, and the meaning of a ray/triangle method's answers.

#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// The closed triangle a b c: edges and vertices belong to it, from either side. Its normal is (b-a)×(c-a).
///
/// Units of the contracts. Let E be the product of the lengths of its two longest edges, P the largest of
/// |a|, |b|, |c|, S = |origin| + P, and L(t) = S + |t||direction|. *Residual* is the distance of p(t) from
/// the triangle's plane: |normal·(p(t) - a)| / (ε·E·L(t)). *Verdict* is the least of the same at the ends of
/// the ray's interval, of |normal·direction| / (ε·E·|direction|) (nearly parallel), and of the three volumes
/// |direction·((a-o)×(b-o))| / (ε·S²·|direction|) (a ray that passes near an edge). *Ulp* is in ulps of the
/// exact t. *Domain* speaks of all numbers of the case that are not 0.
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

/// What every sound method says of its first hit. For the normal K = E / |normal|. For the coordinates K = 1
/// + M²|direction| / |normal·direction|, with M the largest distance of a vertex from the ray's origin, under
/// a transform S.
inline constexpr HitBounds triangle_hit_bounds{.point = {.measured = 1.3, .promised = 2},
                                               .normal = {.measured = 2.78, .promised = 4},
                                               .coordinates = {.measured = 2.32, .promised = 4}};

}  // namespace rayproof
