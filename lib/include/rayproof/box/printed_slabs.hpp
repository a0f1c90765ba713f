#pragma once
#include <rayproof/box.hpp>
#include <rayproof/box/slab.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// Slabs with a precomputed 1/d and no thought of d = 0, **as printed** in the source.
///
/// Where d = 0 the products are ∞ and -∞, which serve, unless the origin is in a face's plane: 0·∞ is NaN,
/// with which every comparison is false, and the ray in the face is lost. SlabsInverse is the mended form.
struct PrintedSlabs {
  static constexpr const char* name = "printed_slabs";
  static constexpr const char* title = "as printed: 0·∞ for a ray in a face";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed,
      .refuted = {{{Claim::robust, "a ray that runs in a face meets 0·∞, which is NaN and no hit"},
                   {Claim::exact, "0·∞ is NaN, and no rounding is to blame"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Box<T>& box) {
    step<T>("Invert the direction",
            "1/d serves both planes of an axis; where a component of d is 0, it is infinite.");
    const vec3<T> d = ray.direction;
    const vec3<T> per_d = named("1/d", vec3<T>{T(1) / d.x, T(1) / d.y, T(1) / d.z});

    step<T>(
        "Meet both planes of each axis, as printed",
        "The two products with 1/d are put in order; a ray in a face has 0·∞ = NaN, and its hit is lost.");
    const vec3<T> below = box.min - ray.origin;
    const vec3<T> above = box.max - ray.origin;
    const Slab<T> x = named_slab("x_in", "x_out", swapped_into_order(below.x * per_d.x, above.x * per_d.x));
    const Slab<T> y = named_slab("y_in", "y_out", swapped_into_order(below.y * per_d.y, above.y * per_d.y));
    const Slab<T> z = named_slab("z_in", "z_out", swapped_into_order(below.z * per_d.z, above.z * per_d.z));
    const auto [t_near, t_far] = overlap(x, y, z);

    step<T>("Drop the box behind the ray, which begins at t_min",
            "A box counts as behind if t_exit < t_min; with NaN that comparison is false, as are "
            "<=, >, >= and =.");
    return chord(select(t_far < ray.t_min, T(not_a_number<T>), t_near), t_far);
  }

 private:
  template <class T>
  static constexpr Slab<T> swapped_into_order(const T& t1, const T& t2) {
    const Mask<T> is_swapped = t2 < t1;
    return {select(is_swapped, t2, t1), select(is_swapped, t1, t2)};
  }
};

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
