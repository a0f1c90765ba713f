#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/plane/implicit.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The plane's equation, and 'parallel' for every ray with n·d = 0, **as printed** in the source: a ray that
/// runs inside the plane is parallel to it and in it.
///
/// Hit or miss and t are those of ByEquation; wrong is what a miss is called, which is why the contact is
/// refuted.
struct PrintedParallel {
  static constexpr const char* name = "printed_parallel";
  static constexpr const char* title = "as printed: a ray inside the plane is parallel";
  static constexpr Source source = sources::lecture_001;
  /// A ray inside the plane is reported as parallel to it, not as in the surface.
  static constexpr bool calls_in_plane_parallel = true;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .residual = {.measured = 1.79, .promised = plane_robust_bound},
      .holds = always_claimed |
               Claims{Claim::residual, Claim::moved, Claim::scaled, Claim::reversed, Claim::bounded},
      .refuted = {
          {{Claim::contact, "a ray inside the plane is called parallel"},
           {Claim::exact, "a ray inside the plane is called parallel, where nothing is rounded either"}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    return ByEquation::roots(ray, plane);
  }
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
