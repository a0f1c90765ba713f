#pragma once
/// \file
/// The axis-aligned box, and the meaning of a ray/box method's answers.

#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// The closed solid min <= q <= max in every coordinate; zero thickness is allowed. Its answer is the
/// interval of t inside it, as `chord` has it.
///
/// Units of the contracts. A box has six planes, and each meets the ray at a t; everything is a comparison of
/// two such t, or of one with an end of the ray's interval. *Verdict* is |s - t| / (ε·(|s| + |t|)) of the
/// pair that decides: of a ray that meets the box, the nearest pair (an entry and its own exit only where the
/// two are taken for one hit); of one that passes it by, the pair that is farthest out of order. Whether a
/// ray along an axis is inside the slabs of the others is decided without rounding, and no band excuses it.
/// *Ulp* is in ulps of the exact t. Under a transform both are those of a parallelepiped. *Domain* speaks of
/// all numbers of the case that are not 0.
template <class T>
struct Box {
  vec3<T> min, max;
};

/// The same box in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Box<To> convert(const Box<From>& box) {
  return {convert<To>(box.min), convert<To>(box.max)};
}

/// The bound, in the units above, that a robust ray/box method keeps (Claim::robust).
inline constexpr double box_robust_bound = 4;

/// What every sound method says of its first hit. K = 1. A face is near p(t) as for *verdict*.
inline constexpr HitBounds box_hit_bounds{.point = {.measured = 1.9, .promised = 2, .is_proven = true},
                                          .normal = {.measured = 3.51, .promised = 4}};

}  // namespace rayproof
