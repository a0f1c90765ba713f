#pragma once
#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/point_in_polygon/winding.hpp>

namespace rayproof::polygon {

/// Where a ray's line meets a polygon's plane, with nothing rounded: t = numerator / denominator, the point
/// in the projection along the largest axis of the exact Newell normal, and its place in the projected
/// polygon.
///
/// Comparisons are made in double where they are clear of its running error, in expansions where not.
class ExactMeeting {
 public:
  using Exact = GrowingExpansion<double>;

  ExactMeeting(const Ray<double>& ray, const Polygon<double>& polygon) {
    const Vec3<Exact> n =
        newell_normal<Exact>(convert<Exact>(polygon).vertices, convert<Exact>(polygon.vertices.front()));
    exact_.denominator = dot(n, convert<Exact>(ray.direction));
    if (is_parallel()) return;
    exact_.numerator = dot(n, convert<Exact>(polygon.vertices.front()) - convert<Exact>(ray.origin));
    const auto bounded = [](const auto& x) {  // an estimate is good to an ulp
      return Bounded<double>::of(estimate(x), 0x1p-51 * abs(estimate(x)));
    };
    bounded_ = {bounded(ratio().numerator), bounded(ratio().denominator)};

    const LargestAxisLast<double> turned(n);
    origin_ = turned.dropped(ray.origin);
    direction_ = turned.dropped(ray.direction);
    for (const glm::dvec3& vertex : polygon.vertices) vertices_.push_back(turned.dropped(vertex));
  }

  /// The ray runs along the plane, or the polygon has no plane.
  [[nodiscard]] bool is_parallel() const { return sign(exact_.denominator) == 0; }

  /// t, for exact_rounding.hpp.
  [[nodiscard]] ExactRatio<24, 24> ratio() const {
    // Within the method's domain the digits of both span no more than 1200 bits.
    return {compressed<24>(exact_.numerator), compressed<24>(exact_.denominator)};
  }

  /// The place of the meeting point in the polygon. Vertices are distinguished from it by the signs of their
  /// coordinates alone: for the winding number, the point may be at 0 and they at -1, 0 and 1.
  [[nodiscard]] Position locate() const {
    PointAndPolygon<double> signs{{0, 0}, {}};
    for (const Vec2<double>& v : vertices_) {
      signs.vertices.push_back({compare(v, &Vec2<double>::x), compare(v, &Vec2<double>::y)});
    }
    return point_in_polygon::locate_by_winding(
        signs, [&](std::size_t i, std::size_t j) { return side(vertices_[i], vertices_[j]); });
  }

 private:
  /// t in one arithmetic.
  template <class N>
  struct Quotient {
    N numerator, denominator;
  };

  /// The sign of a number that `formula` gives times the denominator of t.
  template <class Formula>
  [[nodiscard]] int sign_of(const Formula& formula) const {
    const Bounded<double> rounded = formula(bounded_);
    const int sign_of_value = rounded.value > 0 ? 1 : -1;
    return (rounded.may_be_zero() ? sign(formula(exact_)) : sign_of_value) * sign(exact_.denominator);
  }

  /// One coordinate of the vertex less the point's, times the denominator of t.
  template <class N>
  [[nodiscard]] N offset(const Vec2<double>& vertex, double Vec2<double>::*axis, const Quotient<N>& t) const {
    return (N(vertex.*axis) - N(origin_.*axis)) * t.denominator - t.numerator * N(direction_.*axis);
  }

  /// The sign of one coordinate of the vertex less the point's.
  [[nodiscard]] double compare(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    return sign_of([&](const auto& t) { return offset(vertex, axis, t); });
  }

  /// The sign of the orientation of the point and the side from a to b, which is that of (a - point)×(b - a).
  [[nodiscard]] int side(const Vec2<double>& a, const Vec2<double>& b) const {
    return sign_of([&]<class N>(const Quotient<N>& t) {
      return offset(a, &Vec2<double>::x, t) * (N(b.y) - N(a.y)) -
             offset(a, &Vec2<double>::y, t) * (N(b.x) - N(a.x));
    });
  }

  Quotient<Exact> exact_;
  Quotient<Bounded<double>> bounded_;
  Vec2<double> origin_{};
  Vec2<double> direction_{};
  std::vector<Vec2<double>> vertices_;
};

}  // namespace rayproof::polygon
