#pragma once
/// \file
/// On which side of a directed line a point lies: in rounded numbers, and exactly.

#include <rayproof/arithmetics/expansion.hpp>
#include <rayproof/polygon.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::point_in_polygon {

/// Twice the area of the triangle point, a, b: positive where the point lies to the left of the walk from a
/// to b. Exactly antisymmetric in a and b.
template <class T>
[[nodiscard]] constexpr auto orientation(const Vec2<T>& point, const Vec2<T>& a, const Vec2<T>& b) {
  return (a.x - point.x) * (b.y - point.y) - (a.y - point.y) * (b.x - point.x);
}

/// The exact sign of the orientation of numbers that double holds.
///
/// A double that is clear of its rounding decides it (Shewchuk's ORIENT2D, stage A); else expansions do. No
/// product underflows, since numbers of the domain differ by 2^-452 at least.
template <std::floating_point T>
[[nodiscard]] int orientation_sign(const Vec2<T>& point, const Vec2<T>& a, const Vec2<T>& b) {
  const double x = point.x, y = point.y;
  const double left = (double{a.x} - x) * (double{b.y} - y);
  const double right = (double{a.y} - y) * (double{b.x} - x);
  const double bound =
      0x1.8p-51 * (abs(left) + abs(right));  // 4 roundings of 2^-53 each, and a half to spare
  if (abs(left - right) > bound) return left > right ? 1 : -1;

  const auto expand = [&](const Vec2<T>& q) {
    return Vec2<Expansion<double, 1>>{exact(double{q.x}), exact(double{q.y})};
  };
  return sign(orientation(expand(point), expand(a), expand(b)));
}

}  // namespace rayproof::point_in_polygon

#include <rayproof/rounding/as_before.hpp>
