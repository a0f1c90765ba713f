#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/spawn/surface_point.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// 10⁻⁴ along the normal, whatever the scene's size: too little for a large one, where 10⁻⁴ is less than a
/// rounding error, and larger than all there is in a small one.
///
/// Source: P. Shirley, "Ray Tracing in One Weekend", 2016, as a least t; as a distance in countless programs.
/// Bound: none.
struct Fixed {
  static constexpr const char* name = "fixed";
  static constexpr const char* title = "1e-4 along the normal";
  static constexpr Source source{"P. Shirley", "Ray Tracing in One Weekend", 2016};
  static constexpr bool is_proven = false;
  static constexpr bool moves_to_surface = false;

  template <class T>
  [[nodiscard]] static constexpr vec3<T> origin(const SurfacePoint<T>& from) {
    return from.hit + T(1e-4) * from.normal;
  }
};

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
