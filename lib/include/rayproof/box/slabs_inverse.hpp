#pragma once
#include <array>
#include <rayproof/box.hpp>
#include <rayproof/box/slab.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// Three slabs with one division for each axis: t = (plane - o)·(1/d), where 1/d can be kept with the ray and
/// serve for every box.
///
/// The trap is 0·∞, a NaN, for a ray that runs inside a face; here an axis without motion is asked whether
/// the origin is in its slab, and its product is not looked at. One rounding more than Slabs.
struct SlabsInverse {
  static constexpr const char* name = "slabs_inverse";
  static constexpr const char* title = "slabs, times the inverse of the direction";
  static constexpr Source source{"A. Williams, S. Barrus, R. K. Morley, P. Shirley",
                                 "An Efficient and Robust Ray-Box Intersection Algorithm", 2005};
  static constexpr Contract contract{
      .verdict = {.measured = 1.58, .promised = 4},
      .ulp = {.measured = 1.91, .promised = 3},
      .hit = box_hit_bounds,
      .domain = {.reach_float = 48, .reach_double = 480, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::ulp, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Box<T>& box) {
    const auto [entry, exit] = common_interval(ray, box);
    return chord(entry, exit);
  }

  /// From the last entry to the first exit, not yet compared.
  template <class T>
  [[nodiscard]] static constexpr Slab<T> common_interval(const Ray<T>& ray, const Box<T>& box) {
    const auto [x, y, z] = slabs(ray, box);
    return overlap(x, y, z);
  }

  template <class T>
  [[nodiscard]] static constexpr std::array<Slab<T>, 3> slabs(const Ray<T>& ray, const Box<T>& box) {
    step<T>("Invert the direction, once for all boxes",
            "Each plane then costs a multiplication in place of a division.");
    const vec3<T> d = ray.direction;
    const vec3<T> per_d = named("1/d", vec3<T>{T(1) / d.x, T(1) / d.y, T(1) / d.z});

    step<T>(steps::measure_planes);
    const vec3<T> below = named("min - o", box.min - ray.origin);
    const vec3<T> above = named("max - o", box.max - ray.origin);

    step<T>("Meet both planes of each axis",
            "Each pair of planes bounds a slab; the ray is in it between two t: (min - o)·(1/d) = {min - "
            "o}·{1/d} and (max - o)·(1/d) = {max - o}·{1/d}. Where d is negative along an axis, the ray "
            "enters at max; where it is 0, the ray is in that slab for all t or for none.");
    const Slab<T> x =
        named_slab("x_in", "x_out", slab_of(d.x, below.x, above.x, below.x * per_d.x, above.x * per_d.x));
    const Slab<T> y =
        named_slab("y_in", "y_out", slab_of(d.y, below.y, above.y, below.y * per_d.y, above.y * per_d.y));
    const Slab<T> z =
        named_slab("z_in", "z_out", slab_of(d.z, below.z, above.z, below.z * per_d.z, above.z * per_d.z));
    return {x, y, z};
  }
};

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
