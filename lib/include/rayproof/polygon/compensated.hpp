#pragma once
#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/point_in_polygon/winding.hpp>
#include <rayproof/polygon/by_projection.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// Where a ray's line meets a polygon's plane, with nothing rounded: t = numerator / denominator, the point
/// in the projection along the largest axis of the exact Newell normal, and its place in the projected
/// polygon.
///
/// Comparisons are made in double where they are clear of its rounding, in expansions where not.
class ExactMeeting {
 public:
  using Exact = GrowingExpansion<double>;

  ExactMeeting(const Ray<double>& ray, const Polygon<double>& polygon) {
    const Vec3<Exact> n =
        newell_normal<Exact>(convert<Exact>(polygon).vertices, convert<Exact>(polygon.vertices.front()));
    denominator_ = dot(n, convert<Exact>(ray.direction));
    if (is_parallel()) return;
    numerator_ = dot(n, convert<Exact>(polygon.vertices.front()) - convert<Exact>(ray.origin));

    const LargestAxisLast<double> turned(n);
    origin_ = turned.dropped(ray.origin);
    direction_ = turned.dropped(ray.direction);
    for (const glm::dvec3& vertex : polygon.vertices) vertices_.push_back(turned.dropped(vertex));
    t_ = ratio().approximate;
  }

  /// The ray runs along the plane, or the polygon has no plane.
  [[nodiscard]] bool is_parallel() const { return sign(denominator_) == 0; }

  /// t, for exact_rounding.hpp.
  [[nodiscard]] ExactRatio<Expansion<double, 24>, Expansion<double, 24>> ratio() const {
    // Within the method's domain the digits of both span no more than 1200 bits.
    return {compressed<24>(numerator_), compressed<24>(denominator_)};
  }

  /// The place of the meeting point in the polygon. Vertices are distinguished from it by the signs of their
  /// coordinates alone: for the winding number, the point may be at 0 and they at -1, 0 and 1.
  [[nodiscard]] Position locate() const {
    PointAndPolygon<double> signs{{0, 0}, {}};
    for (const Vec2<double>& v : vertices_) {
      signs.vertices.push_back({double(compare(v, &Vec2<double>::x)), double(compare(v, &Vec2<double>::y))});
    }
    return point_in_polygon::locate_by_winding(
        signs, [&](std::size_t i, std::size_t j) { return side(vertices_[i], vertices_[j]); });
  }

 private:
  /// One coordinate of the vertex less the point's, in double, and a bound on its error: t is good to 3
  /// roundings, and 4 more follow.
  struct ValueAndError {
    double value;
    double error;
    [[nodiscard]] bool is_clear() const { return abs(value) > error; }
  };
  [[nodiscard]] ValueAndError rounded_offset(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    const double moved = t_ * direction_.*axis;
    const double size = abs(origin_.*axis) + abs(moved) + abs(vertex.*axis);
    return {(vertex.*axis - origin_.*axis) - moved, 0x1p-49 * size + 0x1p-960};
  }

  /// The same, exactly, times the denominator.
  [[nodiscard]] Exact exact_offset(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    return (Exact(vertex.*axis) - Exact(origin_.*axis)) * denominator_ - numerator_ * Exact(direction_.*axis);
  }

  /// The sign of one coordinate of the vertex less the point's.
  [[nodiscard]] int compare(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    const ValueAndError offset = rounded_offset(vertex, axis);
    if (offset.is_clear()) return offset.value > 0 ? 1 : -1;
    return sign(exact_offset(vertex, axis)) * sign(denominator_);
  }

  /// The sign of the orientation of the point and the side from a to b, which is that of (a - point)×(b - a).
  [[nodiscard]] int side(const Vec2<double>& a, const Vec2<double>& b) const {
    const ValueAndError x = rounded_offset(a, &Vec2<double>::x);
    const ValueAndError y = rounded_offset(a, &Vec2<double>::y);
    const Vec2<double> edge{b.x - a.x, b.y - a.y};
    const double left = x.value * edge.y;
    const double right = y.value * edge.x;
    const double error = x.error * abs(edge.y) + y.error * abs(edge.x) + 0x1p-51 * (abs(left) + abs(right));
    const ValueAndError orientation{left - right, error + 0x1p-960};
    if (orientation.is_clear()) return orientation.value > 0 ? 1 : -1;

    const Exact exact_left = exact_offset(a, &Vec2<double>::x) * (Exact(b.y) - Exact(a.y));
    const Exact exact_right = exact_offset(a, &Vec2<double>::y) * (Exact(b.x) - Exact(a.x));
    return sign(exact_left - exact_right) * sign(denominator_);
  }

  Exact numerator_;
  Exact denominator_;
  Vec2<double> origin_{};
  Vec2<double> direction_{};
  std::vector<Vec2<double>> vertices_;
  double t_ = 0;
};

/// The Newell normal, the hit point and every orientation in the projection with nothing rounded: sides and
/// vertices are judged exactly, t is rounded once and never across an end of the ray's interval.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±150, beyond which
/// terms of the expansions over- or underflow.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "exact plane and exact winding number";
  static constexpr Source source = sources::shewchuk;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.487, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 0.51},
      .hit = polygon_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 150, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp, Claim::rounded}};

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
    return hit_at(rounded(ray, meeting.ratio()), T(0), T(0));
  }
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
