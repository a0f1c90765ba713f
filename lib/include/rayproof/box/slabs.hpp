#pragma once
#include <rayproof/box.hpp>
#include <rayproof/box/slab.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// Three slabs, a division for each of their six planes; an axis along which the ray does not move is inside
/// its slab or outside.
///
/// Every t has two roundings, the difference's and the quotient's, and is off by no more however far the box
/// is.
struct Slabs {
  static constexpr const char* name = "slabs";
  static constexpr const char* title = "slabs, a division for each plane";
  static constexpr Source source{"T. L. Kay, J. T. Kajiya", "Ray Tracing Complex Scenes", 1986};
  static constexpr Contract contract{
      .verdict = {.measured = 1.58, .promised = 4},
      .ulp = {.measured = 1.47, .promised = 2},
      .hit = box_hit_bounds,
      .domain = {.reach_float = 48, .reach_double = 480, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::ulp, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Box<T>& box) {
    step<T>(steps::measure_planes);
    const vec3<T> below = named("min - o", box.min - ray.origin);
    const vec3<T> above = named("max - o", box.max - ray.origin);
    const vec3<T> d = ray.direction;

    step<T>("Meet both planes of each axis",
            "Each pair of planes bounds a slab; the ray is in it between two t: (min - o) / d = {min - o} / "
            "{d} and (max - o) / d = {max - o} / {d}. Where d is negative along an axis, the ray enters at "
            "max; where it is 0, the ray is in that slab for all t or for none.");
    const Slab<T> x = named_slab("x_in", "x_out", slab_of(d.x, below.x, above.x));
    const Slab<T> y = named_slab("y_in", "y_out", slab_of(d.y, below.y, above.y));
    const Slab<T> z = named_slab("z_in", "z_out", slab_of(d.z, below.z, above.z));
    const auto [entry, exit] = overlap(x, y, z);
    return chord(entry, exit);
  }
};

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
