#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/spawn/surface_point.hpp>

namespace rayproof::spawn {

/// The hit point itself. Half of all rays start on the wrong side of the surface: shadow acne.
///
/// Source: R. Bán, "Számítógépes grafika: Raycasting", 2022, whose secondary rays start so. Bound: none.
struct Nothing {
  static constexpr const char* name = "nothing";
  static constexpr const char* title = "the hit point itself";
  static constexpr Source source{"R. Bán", "Számítógépes grafika: Raycasting", 2022};
  static constexpr bool is_proven = false;
  static constexpr bool moves_to_surface = false;

  template <class T>
  [[nodiscard]] static constexpr vec3<T> origin(const SurfacePoint<T>& from) {
    return from.hit;
  }
};

}  // namespace rayproof::spawn
