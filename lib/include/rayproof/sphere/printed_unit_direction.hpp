#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/sphere/centred.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// The direction made a unit vector in the object's space, and t taken for a distance there: why the source
/// has distances computed again, **as printed**. Left alone, M⁻¹d carries t over unchanged.
///
/// Right where the object-space direction has length 1 already.
struct PrintedUnitDirection {
  static constexpr const char* name = "printed_unit_direction";
  static constexpr const char* title = "as printed: t as a distance in object space";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed,
      .refuted = {{{Claim::robust, "t carries over where M⁻¹d is not normalised; here it was"},
                   {Claim::scaled, "a direction twice as long must halve t"},
                   {Claim::exact, "t is a distance, and no rounding is to blame"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    step<T>("Make the direction a unit vector",
            "From here on t is a length in the object's space, |d| times the t of the given ray: that is the "
            "printed error.");
    const vec3<T> d = ray.direction;
    const T length = named("|d|", sqrt(dot(d, d)));
    const Ray<T> unit{ray.origin, named("d̂", vec3<T>{d.x / length, d.y / length, d.z / length}), ray.t_min,
                      ray.t_max};
    return Centred::roots(unit, sphere);
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
