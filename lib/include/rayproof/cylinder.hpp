#pragma once
/// \file
/// The elliptic cylinder, and the meaning of a ray/cylinder method's answers.

#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// The surface x²/rx² + y²/ry² = 1, 0 <= z <= height; `capped` adds the two closed elliptic disks.
///
/// A line that runs inside the side meets the open cylinder nowhere in particular (no hit; the ring that is
/// left at height 0 it meets once) and the capped one where it passes the two rims. As roots: `lo` and `hi`
/// are the hits of the whole line, ascending, NaN where there is none (also `lo` alone); the discriminant is
/// 0 where the line touches the side and `lo == hi`, positive for one or two hits, negative for none.
///
/// Units of the contracts. In the plane scaled by (1/rx, 1/ry) the side is the unit circle; let S = |origin|
/// there + 1, with p = `far_power` of the bound, and Z(t) = |origin.z| + height + |t||direction.z|.
/// *Residual* of a hit on the side is its distance from the circle in units of ε·S·S^p; of one on a cap, its
/// distance from the cap's plane in units of ε·Z(t). *Verdict* is the least change of the circle's radius
/// (units ε·S·S^p) or of a cap's height (units ε·Z(t)) that changes the number of hits; of a ray that several
/// of them keep from the cylinder, the greatest. Under a transform, which rounds the direction too, the
/// circle's radius counts in units of ε·S(t), S(t) = S + |t||direction| there, where the line is between the
/// heights. *Ulp* is in ulps of the exact t. *Domain* speaks of all numbers of the case that are not 0.
template <class T>
struct Cylinder {
  T rx, ry, height;
  bool capped;
};

/// The same cylinder in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Cylinder<To> convert(const Cylinder<From>& c) {
  return {To(c.rx), To(c.ry), To(c.height), c.capped};
}

/// The bound, in the units above with p = 0, that a robust ray/cylinder method keeps (Claim::robust).
inline constexpr double cylinder_robust_bound = 8;

/// What every sound method says of its first hit. K of a cap is 1. K of the side, with (x, y) = p(t) in the
/// scaled plane, is 1 + S(t)·|(x, y)| / (x₋²·ry/rx + y₋²·rx/ry), S(t) = S + |t||direction| there; x₋ is |x|
/// less 2ε·S(t), under a transform less 8ε·S(t), and no less than 0; y₋ likewise. Side and caps are near p(t)
/// as for *residual*.
///
/// Why x₋ and y₋: p(t) is rounded twice in each coordinate, which moves it by (u, v) with |(u, v)| at most
/// 2ε·S(t) in the scaled plane. On the way there, at (x + s·u, y + s·v) with s from 0 to 1, the normal
/// (x/rx, y/ry) turns by |x·v - y·u| / (x²·ry/rx + y²·rx/ry) for each step of s. The numerator is the same
/// all the way and at most 2ε·S(t)·|(x, y)|, the denominator nowhere less than that of x₋ and y₋: the normal
/// turns by 2ε·K at most. Of a very eccentric cylinder seen from far away that is much more than what the
/// turn at p(t) itself comes to: its rounded point may lie on the other side of the axis.
inline constexpr HitBounds cylinder_hit_bounds{.point = {.measured = 2, .promised = 2, .is_proven = true},
                                               .normal = {.measured = 2.98, .promised = 5}};

}  // namespace rayproof
