#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/spawn/steps.hpp>
#include <rayproof/spawn/surface_point.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// From the point moved onto the surface, along the normal to the far corner of the box that holds the
/// surface, and every component one number further away.
///
/// What it leaves out: the error of the normal, the curvature, and a box of no size, from which it does not
/// move at all. The bounds of the point are those of `surface_point`, which are no wider than the source's
/// own for its shapes.
///
/// Source: M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 4th ed. 2023, 6.8.6
/// OffsetRayOrigin. Bound: none is given.
struct ErrorBounds {
  static constexpr const char* name = "error_bounds";
  static constexpr const char* title = "pbrt: to the corner of the point's error box, rounded away";
  static constexpr Source source{"M. Pharr, W. Jakob, G. Humphreys", "Physically Based Rendering, 6.8.6",
                                 2023};
  static constexpr bool is_proven = false;
  static constexpr bool moves_to_surface = true;

  template <HasSteps T>
  [[nodiscard]] static constexpr vec3<T> origin(const SurfacePoint<T>& from) {
    const T distance = dot(magnitudes<T>(from.normal), from.error);
    const vec3<T> offset = distance * from.normal;
    const vec3<T> moved = from.point + offset;
    return vec3<T>{rounded_away(moved.x, offset.x), rounded_away(moved.y, offset.y),
                   rounded_away(moved.z, offset.z)};
  }

 private:
  /// Adding 0 makes -0, which has no number below it in its bits, a 0.
  template <class T>
  static constexpr T rounded_away(const T& x, const T& offset) {
    const T from = x + T(0);
    const T below = moved_by_steps(select(from == T(0), -from, from), T(-1));
    const T down = select(from == T(0), T(-std::numeric_limits<Plain<T>>::denorm_min()), below);
    const T beyond = select(offset < T(0), down, x);
    return select(T(0) < offset, moved_by_steps(from, T(1)), beyond);
  }
};

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
