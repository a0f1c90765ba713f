#pragma once
#include <rayproof/method/sources.hpp>
#include <rayproof/point_in_polygon/winding.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::point_in_polygon {

/// The winding number with exact orientations: always right, boundary included.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±400, beyond which
/// terms of the expansions over- or underflow.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "winding number with exact orientations";
  static constexpr Source source = sources::shewchuk;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .domain = {.reach_float = 1000, .reach_double = 400, .every_number = true},
      .holds = always_claimed | Claims{Claim::verdict, Claim::robust, Claim::scaled, Claim::exact}};

  template <std::floating_point T>
  [[nodiscard]] static Position locate(const PointAndPolygon<T>& question) {
    if (!polygon::is_finite(question)) return Position::outside;
    return locate_by_winding(
        question, [](const auto& p, const auto& a, const auto& b) { return orientation_sign(p, a, b); });
  }
};

}  // namespace rayproof::point_in_polygon

#include <rayproof/rounding/as_before.hpp>
