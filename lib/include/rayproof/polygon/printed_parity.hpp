#pragma once
#include <rayproof/point_in_polygon/printed_parity.hpp>
#include <rayproof/polygon/by_projection.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// The Newell plane, then point in polygon **as printed** in the source, with sides closed at both ends.
struct PrintedParity : ByProjection<point_in_polygon::PrintedParity> {
  static constexpr const char* name = "printed_parity";
  static constexpr const char* title = "as printed: sides closed at both ends";
  static constexpr Contract contract{
      .standing = Standing::printed,
      .residual = {.measured = 2.76, .promised = polygon_robust_bound},
      .holds = always_claimed | Claims{Claim::residual, Claim::scaled},
      .refuted = {{{Claim::robust, "a ray through the height of a vertex crosses both of its sides"},
                   {Claim::exact, "a vertex at the point's height counts twice where nothing is rounded"}}}};
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
