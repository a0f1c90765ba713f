#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/spawn/surface_point.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// 1500ε·(1 + max|p|) along the normal: 8.9·10⁻⁵ of the point's distance from (0, 0, 0) in float, and never
/// less than that of a scene of size 1.
///
/// Source: W. Jakob et al., "Mitsuba 3", 2022, whose interaction.h had this until 2026. Bound: none.
struct Relative {
  static constexpr const char* name = "relative";
  static constexpr const char* title = "1500 eps (1 + max|p|) along the normal";
  static constexpr Source source{"W. Jakob et al.", "Mitsuba 3", 2022};
  static constexpr bool is_proven = false;
  static constexpr bool moves_to_surface = false;

  template <class T>
  [[nodiscard]] static constexpr vec3<T> origin(const SurfacePoint<T>& from) {
    const vec3<T> size = magnitudes<T>(from.hit);
    const T length = T(1500 * unit<T>) * (T(1) + max(size.x, max(size.y, size.z)));
    return from.hit + length * from.normal;
  }
};

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
