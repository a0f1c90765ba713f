#pragma once
/// \file
/// The disk, and the meaning of a ray/disk method's answers.

#include <rayproof/method/contract.hpp>
#include <rayproof/objects/hull.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// All points of the plane through `center` across `normal` that are within `radius` of the centre: closed,
/// from either side. A radius of 0 makes it a point.
///
/// Units of the contracts. Let N = |normal|, P = |center| + radius, and L(t) = |origin| + P + |t||direction|.
/// *Residual* is the distance of p(t) from the disk's plane: |normal·(p(t) - center)| / (ε·N·L(t)). *Verdict*
/// is the least of the same at the ends of the ray's interval, of s = |normal·direction| / (N·|direction|)
/// over ε (nearly parallel), and of the distance from the point met to the rim times s / (ε·L(t)) (a ray that
/// passes near the rim). *Ulp* is in ulps of the exact t. *Domain* speaks of all numbers of the case that are
/// not 0.
template <class T>
struct Disk {
  vec3<T> center;
  vec3<T> normal;
  T radius;
};

/// The same disk in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Disk<To> convert(const Disk<From>& disk) {
  return {convert<To>(disk.center), convert<To>(disk.normal), To(disk.radius)};
}

/// Along the given normal.
template <class T>
[[nodiscard]] vec3<T> normal_at(const Disk<T>& disk, const vec3<T>& /*anywhere*/) {
  return normalized<T>(disk.normal);
}

/// The cube around the ball of its radius holds it.
inline void enclose(objects::Hull& hull, const Disk<Bounded<double>>& disk) {
  const objects::BoundedPoint reach{disk.radius, disk.radius, disk.radius};
  hull.add_box(disk.center - reach, disk.center + reach);
}

/// The bound, in the units above, that a robust ray/disk method keeps (Claim::robust).
inline constexpr double disk_robust_bound = 4;

/// What every sound method says of its first hit. K = 1.
inline constexpr HitBounds disk_hit_bounds{.point = {.promised = 2}, .normal = {.promised = 4}};

}  // namespace rayproof
