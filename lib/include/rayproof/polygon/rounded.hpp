#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/polygon/exact_meeting.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// Correctly rounded: the verdict is the exact one, sides and vertices included, and t the exact t rounded
/// once, ties to even.
///
/// The Newell normal, the hit point and its orientation to each side are formed in double with a bound on
/// their errors, and with nothing rounded where that leaves a doubt; so is t, of a ray in double after
/// double-double, and under a transform at once with nothing rounded. No answer is rounded across an end of
/// the ray's interval.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±150, beyond which
/// terms of the expansions over- or underflow; under a transform within 2^±24.
struct Rounded {
  static constexpr const char* name = "rounded";
  static constexpr const char* title = "correctly rounded: with more digits, exact where in doubt";
  static constexpr Source source = sources::ziv;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.487, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 0.51},
      .hit = polygon_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 150, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp, Claim::rounded}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Polygon<T>& polygon) {
    return met_exactly<Rounded>(ray, polygon);
  }

  /// The same under a transform.
  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                                 const Polygon<T>& polygon) {
    return met_exactly<Rounded>(space, ray, polygon);
  }

  /// Where a ray from o along d meets the polygon, as met_exactly has them.
  template <std::floating_point T, class Number, class Unit>
  [[nodiscard]] static FlatHit<T> meet(const Ray<T>& ray, const Polygon<T>& polygon, const Vec3<Number>& o,
                                       const Vec3<Number>& d, const Unit& unit) {
    if (polygon.vertices.empty()) return no_hit<T>;
    step<T>(
        "Meet the plane of the Newell normal",
        "The Newell normal is the sum of the cross products of neighbouring vertices, formed exactly where "
        "rounding leaves a doubt.");
    const ExactMeeting meeting(polygon, o, d, unit);
    if (meeting.is_parallel()) return no_hit<T>;

    step<T>("Find the meeting point's place in the polygon, exactly",
            "Exact signs of the orientations give the winding number, and so inside, boundary or outside.");
    if (meeting.locate() == Position::outside) return no_hit<T>;

    step<T>("Round t once", "The quotient is exact until here.");
    const auto [t, error] = meeting.enclosed_t(ray);
    const auto quick = rounding_test(convert<double>(ray), t, error);
    if (quick.is_sure) return hit_at(static_cast<T>(quick.answer), T(0), T(0));
    return hit_at(rounded(ray, meeting.ratio()), T(0), T(0));
  }
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
