#pragma once
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::point_in_polygon {

/// Inside where a ray along +x crosses the sides an odd number of times. A side holds its lower end and not
/// its upper one, so that a ray through a vertex counts right and a horizontal side does not divide by 0.
///
/// The boundary is what rounds to it: a crossing at t = 0, a horizontal side, a vertex.
struct Parity {
  static constexpr const char* name = "parity";
  static constexpr const char* title = "odd or even crossings of half-open sides";
  static constexpr Source source{"E. Haines", "Point in Polygon Strategies, Graphics Gems IV", 1994};
  static constexpr Contract contract{
      .verdict = {.measured = 2, .promised = point_in_polygon_robust_bound},
      .holds = always_claimed | Claims{Claim::verdict, Claim::robust, Claim::scaled, Claim::exact}};

  template <Branching T>
  [[nodiscard]] static Position locate(const PointAndPolygon<T>& question) {
    if (!polygon::is_finite(question)) return Position::outside;
    step<T>("Count the sides that a ray along +x crosses",
            "An odd number means inside; a side has its lower end and not its upper one, so no vertex counts "
            "twice.");
    const Vec2<T> p = question.point;
    bool is_odd = false;
    bool is_on_side = false;
    polygon::for_each_side(question.vertices, [&](const Vec2<T>& a, const Vec2<T>& b) {
      if (polygon::passes(p.y, a, b)) {
        const T t = polygon::cross_side(p, a, b).t;
        if (t == T(0)) is_on_side = true;
        if (t > T(0)) is_odd = !is_odd;
      } else if (a.y == p.y && polygon::is_between(p, a, b) && (a.y == b.y || a.x == p.x)) {
        is_on_side = true;  // on a horizontal side, or at the upper end of one
      }
    });
    if (is_on_side) return Position::boundary;
    return is_odd ? Position::inside : Position::outside;
  }
};

}  // namespace rayproof::point_in_polygon

#include <rayproof/rounding/as_before.hpp>
