#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/point_in_polygon/printed_parity.hpp>
#include <rayproof/polygon/in_plane.hpp>

namespace rayproof::polygon {

/// The Newell plane, then point in polygon **as printed** in the source, with sides closed at both ends.
///
/// Kept so that the property tests refute it.
struct PrintedParity {
  static constexpr const char* name = "printed_parity";
  static constexpr const char* title = "as printed: sides closed at both ends";
  static constexpr Source source = point_in_polygon::PrintedParity::source;
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .residual = {.measured = 0.759, .promised = polygon_robust_bound},
      .holds = always_claimed | Claims{Claim::residual, Claim::scaled},
      .refuted = {{{Claim::robust, "a ray through the height of a vertex crosses both of its sides"}}}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Polygon<T>& polygon) {
    return meet_by<point_in_polygon::PrintedParity>(ray, polygon);
  }
};

}  // namespace rayproof::polygon
