#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/spawn/steps.hpp>
#include <rayproof/spawn/surface_point.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// Each component moved by 256·n numbers of its format, and by n·2^-16 where it is smaller than 1/32. In
/// double, for which it was not published, by as many numbers, and by n·2^-45.
///
/// Large coordinates of one axis say nothing of the error along another, and a component of n below 1/256
/// moves nothing: a surface nearly along an axis, far away in that axis, is hit again.
///
/// Source: C. Wächter, N. Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems
/// ch. 6, 2019. Bound: none; the constants are found by experiment.
struct IntegerOffset {
  static constexpr const char* name = "integer_offset";
  static constexpr const char* title = "256 n numbers of the format, component by component";
  static constexpr Source source{
      "C. Wächter, N. Binder",
      "A Fast and Robust Method for Avoiding Self-Intersection, Ray Tracing Gems ch. 6", 2019};
  static constexpr bool is_proven = false;
  static constexpr bool moves_to_surface = false;

  template <HasSteps T>
  [[nodiscard]] static constexpr vec3<T> origin(const SurfacePoint<T>& from) {
    const vec3<T>&p = from.hit, &n = from.normal;
    return vec3<T>{moved(p.x, n.x), moved(p.y, n.y), moved(p.z, n.z)};
  }

 private:
  template <class T>
  static constexpr T moved(const T& p, const T& n) {
    const Plain<T> near_zero = sizeof(Plain<T>) == 4 ? Plain<T>(0x1p-16) : Plain<T>(0x1p-45);
    const T whole = copysign(floor(T(256) * abs(n)), n);
    return select(abs(p) < T(0x1p-5), p + T(near_zero) * n, moved_by_steps(p, whole));
  }
};

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
