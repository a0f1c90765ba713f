#pragma once
/// \file
/// Where a ray's line meets a polygon, without a wrong sign: in double, exact where that leaves a doubt.

#include <optional>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/formulas/rounding_test.hpp>
#include <rayproof/point_in_polygon/winding.hpp>
#include <rayproof/polygon/quotient.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// Where a ray's line meets a polygon's plane: t, the point in the projection along the largest axis of the
/// Newell normal, and its place in the projected polygon. What double leaves in doubt is asked of the exact
/// quotient.
class ExactMeeting {
 public:
  using Exact = ExactQuotient::Exact;

  ExactMeeting(const Ray<double>& ray, Polygon<double> polygon) : ray_(ray), polygon_(std::move(polygon)) {
    const auto quick = EnclosedQuotient<double>::of(ray_, polygon_);
    if (quick.is_sure()) {
      turned_ = LargestAxisLast<double>(quick.normal_in_double());
      t_ = quick.t();
      t_error_ = quick.error_of_t();
    } else {
      turned_ = LargestAxisLast<double>(exact().normal);
      if (is_parallel()) return;
      t_ = ratio().approximate;
      t_error_ = 0x1.4p-51 * abs(t_);  // three roundings, and two
    }
    origin_ = dropped(ray.origin);
    direction_ = dropped(ray.direction);
  }

  /// The ray runs along the plane, or the polygon has no plane.
  [[nodiscard]] bool is_parallel() const { return exact_.has_value() && sign(exact_->D) == 0; }

  /// t with more digits than T, and a bound on its error less two roundings.
  template <std::floating_point T>
  [[nodiscard]] std::pair<WiderThan<T>, double> enclosed_t() const {
    using W = WiderThan<T>;
    if constexpr (std::same_as<W, double>) {
      return {t_, t_error_};
    } else {
      const auto quotient = EnclosedQuotient<W>::of(convert<W>(ray_), convert<W>(polygon_));
      return {quotient.t(), quotient.error_of_t()};
    }
  }
  /// t without rounding.
  [[nodiscard]] ExactQuotient::Ratio ratio() const { return exact().ratio(); }

  /// The place of the meeting point in the polygon. Vertices are distinguished from it by the signs of their
  /// coordinates alone: for the winding number, the point may be at 0 and they at -1, 0 and 1.
  [[nodiscard]] Position locate() const {
    PointAndPolygon<double> signs{{0, 0}, {}};
    signs.vertices.reserve(polygon_.vertices.size());
    for (const vec3<double>& vertex : polygon_.vertices) {
      const Vec2<double> v = dropped(vertex);
      signs.vertices.push_back({double(compare(v, &Vec2<double>::x)), double(compare(v, &Vec2<double>::y))});
    }
    return point_in_polygon::locate_by_winding(signs, [&](std::size_t i, std::size_t j) {
      return side(dropped(polygon_.vertices[i]), dropped(polygon_.vertices[j]));
    });
  }

 private:
  /// One coordinate of the vertex less the point's, in double, and a bound on its error: 4 roundings
  /// beside that of t.
  struct ValueAndError {
    double value;
    double error;
    [[nodiscard]] bool is_clear() const { return abs(value) > error; }
  };
  [[nodiscard]] ValueAndError rounded_offset(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    const double moved = t_ * direction_.*axis;
    const double size = abs(origin_.*axis) + abs(moved) + abs(vertex.*axis);
    return {(vertex.*axis - origin_.*axis) - moved,
            t_error_ * abs(direction_.*axis) + 0x1p-50 * size + 0x1p-960};
  }

  /// The same, exactly, times the denominator.
  [[nodiscard]] Exact exact_offset(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    return (Exact(vertex.*axis) - Exact(origin_.*axis)) * exact().D - exact().N * Exact(direction_.*axis);
  }

  /// The sign of one coordinate of the vertex less the point's.
  [[nodiscard]] int compare(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    const ValueAndError offset = rounded_offset(vertex, axis);
    if (offset.is_clear()) return offset.value > 0 ? 1 : -1;
    return sign(exact_offset(vertex, axis)) * sign(exact().D);
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
    return sign(exact_left - exact_right) * sign(exact().D);
  }

  /// A vector in the projection.
  [[nodiscard]] Vec2<double> dropped(const vec3<double>& v) const { return turned_.dropped(v); }

  /// Formed where it is first asked for.
  [[nodiscard]] const ExactQuotient& exact() const {
    if (!exact_.has_value()) exact_ = ExactQuotient::of(ray_, polygon_);
    return *exact_;
  }

  Ray<double> ray_;
  Polygon<double> polygon_;
  mutable std::optional<ExactQuotient> exact_;
  LargestAxisLast<double> turned_{vec3<double>{}};
  Vec2<double> origin_{}, direction_{};
  double t_ = 0, t_error_ = 0;
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
