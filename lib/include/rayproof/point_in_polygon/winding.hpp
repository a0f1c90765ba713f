#pragma once
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/point_in_polygon/orientation.hpp>
#include <utility>
#include <vector>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::point_in_polygon {

/// How often a polygon winds about a point, from the sides that pass its level with it on their left
/// (upward: +1) or on their right (downward: -1); nothing is divided. `height(i)` is vertex i's,
/// `side(i, j)` the orientation of the point and the side from vertex i to vertex j, or its sign; where that
/// is 0, `is_between(i, j)` is whether the point lies between the two.
///
/// Inside is where the winding number is odd: the even-odd rule. Where a polygon runs twice about a point,
/// the point is wound about and yet outside.
template <Branching T, class Height, class Side, class IsBetween>
[[nodiscard]] Position locate_by_winding(const T& level, std::size_t count, Height&& height, Side&& side,
                                         IsBetween&& is_between) {
  step<T>("Add up the turns of the sides about the point",
          "At the point's height, a rising side with the point on its left counts +1 and a falling side with "
          "it on its right −1; an odd sum means inside.");
  int winding = 0;
  bool is_on_side = false;
  if (count == 0) return Position::outside;
  T b = height(0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = polygon::next(i, count);
    const T a = std::exchange(b, height(j));
    const bool is_beside = min(a, b) <= level && level <= max(a, b);
    if (!is_beside) continue;
    const auto orientation = side(i, j);
    if (orientation == 0) is_on_side = is_on_side || is_between(i, j);
    if (!polygon::passes(level, a, b)) continue;
    const bool is_upward = a < b;
    if (is_upward && orientation > 0) ++winding;
    if (!is_upward && orientation < 0) --winding;
  }
  if (is_on_side) return Position::boundary;
  return winding % 2 != 0 ? Position::inside : Position::outside;
}

/// The same of a point and vertices that are given; `side(p, a, b)` is the orientation of a point and a side.
template <Branching T, class Side>
[[nodiscard]] Position locate_by_winding(const PointAndPolygon<T>& question, Side&& side) {
  const Vec2<T>& p = question.point;
  const std::vector<Vec2<T>>& v = question.vertices;
  return locate_by_winding(
      p.y, v.size(), [&](std::size_t i) { return v[i].y; },
      [&](std::size_t i, std::size_t j) { return side(p, v[i], v[j]); },
      [&](std::size_t i, std::size_t j) { return polygon::is_between(p, v[i], v[j]); });
}

/// The winding number in rounded numbers, inside where it is odd.
///
/// Needs no division. A point whose orientation to a side rounds to 0 between the side's ends is on the
/// boundary.
struct Winding {
  static constexpr const char* name = "winding";
  static constexpr const char* title = "odd or even winding number, without division";
  static constexpr Source source{"K. Hormann, A. Agathos",
                                 "The Point in Polygon Problem for Arbitrary Polygons", 2001};
  static constexpr Contract contract{
      .verdict = {.measured = 0.715, .promised = point_in_polygon_robust_bound},
      .holds = always_claimed | Claims{Claim::verdict, Claim::robust, Claim::scaled, Claim::exact}};

  template <Branching T>
  [[nodiscard]] static Position locate(const PointAndPolygon<T>& question) {
    if (!polygon::is_finite(question)) return Position::outside;
    return locate_by_winding(
        question, [](const auto& p, const auto& a, const auto& b) { return orientation(p, a, b); });
  }
};

}  // namespace rayproof::point_in_polygon

#include <rayproof/rounding/as_before.hpp>
