#pragma once
#include <rayproof/disk.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::disk {

/// t = n·(c - o) / (n·d), and a hit where |o + t·d - c|² <= r².
///
/// The offset from the centre is formed from c - o, so that a disk far from the world's origin loses no more
/// digits than its distance from the ray's. A ray with n·d = 0 is parallel to the disk or runs inside its
/// plane: a miss.
struct Projected {
  static constexpr const char* name = "projected";
  static constexpr const char* title = "the plane first, then the distance from the centre";
  static constexpr Source source{"A. S. Glassner (ed.)", "An Introduction to Ray Tracing, ch. 2", 1989};
  static constexpr Contract contract{
      .verdict = {.measured = 0.516, .promised = disk_robust_bound},
      .residual = {.measured = 1.71, .promised = disk_robust_bound},
      .hit = disk_hit_bounds,
      .domain = {.reach_float = 28, .reach_double = 240, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Disk<T>& disk) {
    step<T>("Meet the plane of the disk",
            "t is the distance to the plane over the ray's progress towards it, both along the normal.");
    const vec3<T> f = named("f", disk.center - ray.origin);
    const T along = named("n·d", dot(disk.normal, ray.direction));
    const T t = named("t", dot(disk.normal, f) / along);
    step<T>("Compare the distance from the centre with the radius",
            "q leads from the centre to the point; squares are compared, so that no root is taken.");
    const vec3<T> q = named("q", t * ray.direction - f);
    const Mask<T> is_inside = named("|q|²", dot(q, q)) <= named("r²", disk.radius * disk.radius);
    return flat_hit(along != T(0) && is_inside, t, T(0), T(0));
  }
};

}  // namespace rayproof::disk

#include <rayproof/rounding/as_before.hpp>
