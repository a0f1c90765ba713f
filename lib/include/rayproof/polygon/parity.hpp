#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/point_in_polygon/parity.hpp>
#include <rayproof/polygon/in_plane.hpp>

namespace rayproof::polygon {

/// The Newell plane, then the crossings of half-open sides in the projection.
///
/// The rounding of the hit point decides beside the boundary.
struct Parity {
  static constexpr const char* name = "parity";
  static constexpr const char* title = "Newell plane, then odd or even crossings";
  static constexpr Source source = point_in_polygon::Parity::source;
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .verdict = {.measured = 0.346, .promised = polygon_robust_bound},
      .residual = {.measured = 0.759, .promised = polygon_robust_bound},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::robust, Claim::moved,
                                       Claim::scaled, Claim::reversed}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Polygon<T>& polygon) {
    return meet_by<point_in_polygon::Parity>(ray, polygon);
  }
};

}  // namespace rayproof::polygon
