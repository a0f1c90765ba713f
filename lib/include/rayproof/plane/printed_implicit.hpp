#pragma once
#include <rayproof/plane/implicit.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// t = -(x₀ + y₀ + z₀ + D) / (n·d), **as printed** in the source: the coefficients A, B, C are missing in the
/// numerator.
///
/// Right only for A = B = C = 1. ByEquation is the mended form.
struct PrintedImplicit {
  static constexpr const char* name = "printed_implicit";
  static constexpr const char* title = "as printed: no coefficients in the numerator";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed,
      .refuted = {{{Claim::robust, "the numerator must be Ax₀ + By₀ + Cz₀ + D"},
                   {Claim::exact, "without the coefficients the numerator is wrong, rounded or not"}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    const auto [n, D] = as_implicit(plane);

    step<T>("Put the ray into the plane's equation, as printed",
            "The coefficients of x₀, y₀ and z₀ are missing: the value at the ray's origin is n·o + D.");
    const vec3<T> o = ray.origin;
    const T at_origin = named("x₀ + y₀ + z₀ + D", o.x + o.y + o.z + D);
    const T along = named("n·d", dot(n, ray.direction));
    return solved_for_t(at_origin, along);
  }
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
