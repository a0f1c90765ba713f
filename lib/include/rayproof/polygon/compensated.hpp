#pragma once
#include <rayproof/method/method.hpp>
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
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0},
      .residual = {.measured = 0.403, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 1},
      .domain = {.reach_float = 1000, .reach_double = 150, .every_number = true},
      .holds = robust_claims | Claims{Claim::residual, Claim::ulp}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Polygon<T>& polygon) {
    if (!are_finite(ray.origin, ray.direction) || !is_finite(polygon)) return no_hit<T>;
    step<T>("Meet the plane of the exact Newell normal",
            "The Newell normal is the sum of the cross products of neighbouring vertices; nothing in it is "
            "rounded.");
    const ExactMeeting meeting(convert<double>(ray), convert<double>(polygon));
    if (meeting.is_parallel()) return no_hit<T>;

    step<T>("Find the meeting point's place in the polygon, exactly",
            "Exact orientations give the winding number, and so inside, boundary or outside.");
    if (meeting.locate() == Position::outside) return no_hit<T>;

    step<T>("Round t once", "The quotient is exact until here.");
    return flat_hit(true, rounded(ray, meeting.ratio()), T(0), T(0));
  }
};

}  // namespace rayproof::polygon
