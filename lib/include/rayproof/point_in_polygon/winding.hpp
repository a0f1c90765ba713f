#pragma once
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/point_in_polygon/orientation.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::point_in_polygon {

/// How often the polygon winds about a point, from the sides that pass its height with it on their left
/// (upward: +1) or on their right (downward: -1); nothing is divided. `side(i, j)` is the orientation of the
/// point and the side from vertex i to vertex j, or its sign.
///
/// Inside is where the winding number is odd: the even-odd rule. Where a polygon runs twice about a point,
/// the point is wound about and yet outside. `vertices` may be made in turn.
template <Branching T, class Vertices, class Side>
[[nodiscard]] Position locate_by_winding(const Vec2<T>& p, const Vertices& vertices, Side&& side) {
  step<T>("Add up the turns of the sides about the point",
          "At the point's height, a rising side with the point on its left counts +1 and a falling side with "
          "it on its right −1; an odd sum means inside.");
  int winding = 0;
  bool is_on_side = false;
  const std::size_t count = vertices.size();
  if (count == 0) return Position::outside;
  Vec2<T> b = vertices[0];
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = polygon::next(i, count);
    const Vec2<T> a = std::exchange(b, vertices[j]);
    const bool is_beside = min(a.y, b.y) <= p.y && p.y <= max(a.y, b.y);
    if (!is_beside) continue;
    const auto orientation = side(i, j);
    if (orientation == 0) is_on_side = is_on_side || polygon::is_between(p, a, b);
    if (!polygon::passes(p.y, a, b)) continue;
    const bool is_upward = a.y < b.y;
    if (is_upward && orientation > 0) ++winding;
    if (!is_upward && orientation < 0) --winding;
  }
  if (is_on_side) return Position::boundary;
  return winding % 2 != 0 ? Position::inside : Position::outside;
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
    return locate_by_winding(question.point, question.vertices, [&](std::size_t i, std::size_t j) {
      return orientation(question.point, question.vertices[i], question.vertices[j]);
    });
  }
};

}  // namespace rayproof::point_in_polygon

#include <rayproof/rounding/as_before.hpp>
