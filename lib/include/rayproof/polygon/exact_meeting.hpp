#pragma once
/// \file
/// Where a ray's line meets a polygon, without a wrong sign: in double, exact where that leaves a doubt.

#include <optional>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/formulas/rounding_test.hpp>
#include <rayproof/point_in_polygon/winding.hpp>
#include <rayproof/polygon/by_projection.hpp>
#include <rayproof/polygon/quotient.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// Where a ray's line meets a polygon's plane: t, the point in the projection along the largest axis of the
/// Newell normal, and its place in the projected polygon. What double leaves in doubt is asked of the exact
/// quotient. The ray leads from o along d, as met_exactly has them.
template <class T, class Vector, class Unit>
class ExactMeeting {
 public:
  using Exact = ExactQuotient::Exact;

  /// Valid as long as the polygon and the unit.
  ExactMeeting(const Polygon<T>& polygon, const Vector& o, const Vector& d, const Unit& unit)
      : polygon_(polygon), o_(o), d_(d), unit_(unit) {
    const vec3<double> origin = approximate(o), direction = approximate(d);
    const auto quick = EnclosedQuotient<double>::of({origin, direction}, polygon, is_ray_given);
    if (quick.is_sure()) {
      turned_ = LargestAxisLast<double>(quick.normal_in_double());
      t_ = quick.t();
      t_error_ = quick.error_of_t();
    } else {
      has_plane_ = is_finite(polygon);  // never sure where it is not: a size is infinite or NaN
      if (!has_plane_) return;
      turned_ = LargestAxisLast<double>(exact().normal);
      if (is_parallel()) return;
      t_ = ratio().approximate;
      t_error_ = 0x1.4p-51 * abs(t_);  // three roundings, and two
    }
    const Vec2<double> along = turned_.dropped(direction);
    origin_ = turned_.dropped(origin);
    moved_ = {t_ * along.x, t_ * along.y};
    const auto doubt = [&](double from, double by, double slope) {
      return t_error_ * abs(slope) + rounding * (abs(from) + abs(by)) + 0x1p-960;
    };
    doubt_ = {doubt(origin_.x, moved_.x, along.x), doubt(origin_.y, moved_.y, along.y)};
  }

  /// The ray runs along the plane, or the polygon has no plane.
  [[nodiscard]] bool is_parallel() const {
    return !has_plane_ || (exact_.has_value() && sign(exact_->D) == 0);
  }

  /// t with more digits than T, and a bound on its error less two roundings; of `ray` itself, where it is
  /// given, in double-double for a T of double.
  [[nodiscard]] std::pair<WiderThan<T>, double> enclosed_t(const Ray<T>& ray) const {
    using W = WiderThan<T>;
    if constexpr (is_ray_given && !std::same_as<W, double>) {
      const auto quotient = EnclosedQuotient<W>::of(convert<W>(ray), polygon_);
      return {quotient.t(), quotient.error_of_t()};
    } else {
      return {W(t_), t_error_};
    }
  }
  /// t without rounding.
  [[nodiscard]] ExactQuotient::Ratio ratio() const { return exact().ratio(); }

  /// The place of the meeting point in the polygon. Vertices are distinguished from it by the signs of their
  /// coordinates alone: for the winding number, the point may be at 0 and they at -1, 0 and 1.
  [[nodiscard]] Position locate() const {
    const auto sign_of = [&](std::size_t i, double Vec2<double>::*axis) {
      return double(compare(dropped(i), axis));
    };
    const auto signs = [&](std::size_t i) {
      return Vec2<double>{sign_of(i, &Vec2<double>::x), sign_of(i, &Vec2<double>::y)};
    };
    return point_in_polygon::locate_by_winding(
        0.0, polygon_.vertices.size(), [&](std::size_t i) { return sign_of(i, &Vec2<double>::y); },
        [&](std::size_t i, std::size_t j) { return side(dropped(i), dropped(j)); },
        [&](std::size_t i, std::size_t j) {
          return is_between(Vec2<double>{0, 0}, signs(i), signs(j));
        });
  }

 private:
  static constexpr bool is_ray_given = std::same_as<Unit, UnitFactor>;
  /// What differences of products of the ray's coordinates are off by, in parts of their terms: 4 roundings
  /// of their own, and 5.1 of each coordinate where the ray is not given; and some for the bound's own.
  static constexpr double rounding = is_ray_given ? 0x1p-50 : 0x1p-49;

  /// A vector of the ray, within 5.1 roundings.
  [[nodiscard]] vec3<double> approximate(const Vector& v) const {
    const auto& [x, y, z] = v;
    if constexpr (is_ray_given) {
      return {estimate(x), estimate(y), estimate(z)};
    } else {
      const double unit = estimate(unit_);
      return {estimate(x) / unit, estimate(y) / unit, estimate(z) / unit};
    }
  }

  /// One coordinate of the vertex less the point's, in double, and a bound on its error.
  struct ValueAndError {
    double value;
    double error;
    [[nodiscard]] bool is_clear() const { return abs(value) > error; }
  };
  [[nodiscard]] ValueAndError rounded_offset(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    return {(vertex.*axis - origin_.*axis) - moved_.*axis, doubt_.*axis + rounding * abs(vertex.*axis)};
  }

  /// The same, exactly, times the denominator and the unit.
  [[nodiscard]] Exact exact_offset(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    const double number_of_axis = turned_.dropped({0, 1, 2}).*axis;
    const auto coordinate = [&](const Vector& v) {
      return Exact(number_of_axis == 0 ? v.x : number_of_axis == 1 ? v.y : v.z);
    };
    return (unit_ * Exact(vertex.*axis) - coordinate(o_)) * exact().D - exact().N * coordinate(d_);
  }

  /// The sign of one coordinate of the vertex less the point's.
  [[nodiscard]] int compare(const Vec2<double>& vertex, double Vec2<double>::*axis) const {
    const ValueAndError offset = rounded_offset(vertex, axis);
    if (offset.is_clear()) return offset.value > 0 ? 1 : -1;
    return sign(exact_offset(vertex, axis)) * sign_of_factors();
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
    return sign(exact_left - exact_right) * sign_of_factors();
  }

  /// Of what exact offsets are multiplied by.
  [[nodiscard]] int sign_of_factors() const { return sign(exact().D) * sign(unit_); }

  /// A vertex in the projection.
  [[nodiscard]] Vec2<double> dropped(std::size_t i) const {
    return turned_.dropped(convert<double>(polygon_.vertices[i]));
  }

  /// Formed where it is first asked for.
  [[nodiscard]] const ExactQuotient& exact() const {
    if (!exact_.has_value()) exact_ = ExactQuotient::of(o_, d_, unit_, polygon_);
    return *exact_;
  }

  const Polygon<T>& polygon_;
  const Vector o_, d_;
  const Unit& unit_;
  mutable std::optional<ExactQuotient> exact_;
  bool has_plane_ = true;
  LargestAxisLast<double> turned_{vec3<double>{}};
  Vec2<double> origin_{}, moved_{}, doubt_{};
  double t_ = 0, t_error_ = 0;
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
