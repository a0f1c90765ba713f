#pragma once
#include <rayproof/formulas/finite.hpp>
#include <rayproof/method/contract.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/method/sources.hpp>
#include <rayproof/polygon/exact_meeting.hpp>
#include <rayproof/polygon/in_plane.hpp>

namespace rayproof::polygon {

/// The Newell normal, the hit point and every orientation in the projection with nothing rounded: sides and
/// vertices are judged exactly, t is within 0.501 ulp and never rounded across an end of the ray's interval.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±150, beyond which
/// terms of the expansions over- or underflow.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "exact plane and exact winding number";
  static constexpr Source source = sources::shewchuk;
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0},
      .residual = {.measured = 0.403, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 1},
      .domain = {.reach_float = 1000, .reach_double = 150, .every_number = true},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::ulp, Claim::robust,
                                       Claim::moved, Claim::scaled, Claim::reversed}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Polygon<T>& polygon) {
    const FlatHit<T> no_hit = flat_hit(false, T(not_a_number<T>), T(0), T(0));
    if (!are_finite(ray.origin, ray.direction) || !is_finite(polygon)) {
      return no_hit;
    }
    step<T>("Meet the plane of the exact Newell normal",
            "The Newell normal is the sum of the cross products of neighbouring vertices; nothing in it is "
            "rounded.");
    const ExactMeeting meeting(convert<double>(ray), convert<double>(polygon));
    if (meeting.is_parallel()) return no_hit;

    step<T>("Find the meeting point's place in the polygon, exactly",
            "Exact orientations give the winding number, and so inside, boundary or outside.");
    if (meeting.locate() == Position::outside) return no_hit;

    step<T>("Round t once", "The quotient is exact until here.");
    return flat_hit(true, rounded(ray, meeting.ratio()), T(0), T(0));
  }
};

}  // namespace rayproof::polygon
