#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// Barycentric coordinates from the equations of x and y whatever the triangle's attitude, **as printed** in
/// the source: z is always dropped.
///
/// A triangle perpendicular to the xy plane has no area in x and y and is never hit; one nearly so is hit at
/// random. PlaneProjection is the mended form.
struct PrintedXy {
  static constexpr const char* name = "printed_xy";
  static constexpr const char* title = "as printed: barycentric coordinates in x and y alone";
  static constexpr Source source = sources::drabek;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .residual = {.measured = 1.24, .promised = triangle_robust_bound},
      .holds = always_claimed | Claims{Claim::residual},
      .refuted = {
          {{Claim::robust, "a triangle perpendicular to the xy plane has no area in x and y"},
           {Claim::exact, "a triangle perpendicular to the xy plane is lost where nothing is rounded"}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    const auto [t, q, n] = meet_plane(ray, triangle);
    const auto drop_z = [](const vec3<T>& p) { return Vec2<T>{p.x, p.y}; };

    step<T>("Find the barycentric coordinates in x and y, as printed",
            "z is ignored, and a triangle perpendicular to the xy plane has no area in x and y.");
    return hit_inside(t, barycentric(drop_z(q), drop_z(triangle.a), drop_z(triangle.b), drop_z(triangle.c)));
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
