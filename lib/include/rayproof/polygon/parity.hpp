#pragma once
#include <rayproof/point_in_polygon/parity.hpp>
#include <rayproof/polygon/by_projection.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// The Newell plane, then the crossings of half-open sides in the projection.
///
/// The rounding of the hit point decides beside the boundary.
struct Parity : ByProjection<point_in_polygon::Parity> {
  static constexpr const char* name = "parity";
  static constexpr const char* title = "Newell plane, then odd or even crossings";
  static constexpr Contract contract{.verdict = {.measured = 0.915, .promised = polygon_robust_bound},
                                     .residual = {.measured = 3.8, .promised = polygon_robust_bound},
                                     .hit = polygon_hit_bounds,
                                     .holds = robust_claims | hit_claims | Claims{Claim::residual}};
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
