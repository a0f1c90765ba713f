#pragma once
/// \file
/// A point and a polygon in the plane, laid out for one difficulty each. The families of both polygon topics
/// are made of them.

#include "generators/draw.hpp"
#include "generators/outline.hpp"

namespace rayproof::outline_layout {

using PolygonCase = PointAndPolygon<double>;

struct Layout {
  const char* name;
  const char* description;
  bool is_exact;  ///< all numbers are so short that nothing made of them is rounded
  PolygonCase (*plan)(Random&);
};

/// An outline of whole vertices, of any kind.
[[nodiscard]] inline Outline whole_outline(Random& random) {
  const int kind = random.between(0, 3);
  if (kind == 0) return turned(random, comb(random, random.between(1, 6)));
  if (kind == 2) return scattered(random, vertex_count(random), 8);
  const Outline vertices = scattered(random, random.between(3, 8), 4);
  return kind == 1 ? padded(random, vertices) : vertices;
}

/// `vertices` and a point of coordinates from `number()`.
[[nodiscard]] PolygonCase with_point(const Outline& vertices, auto&& number) {
  return {{number(), number()}, vertices};
}

inline constexpr Layout everyday{
    "random", "a star of 3 to 24 corners, seldom more; about half the points inside", false,
    [](Random& random) {
      return with_point(star(random, vertex_count(random)), [&] { return random.uniform(-5, 5); });
    }};

inline constexpr Layout level{
    "level", "in whole numbers: the point is level with vertices and sides", true,
    [](Random& random) -> PolygonCase {
      const Outline vertices = whole_outline(random);
      const Vec2<double> one = vertices[some_index(random, vertices)],
                         other = vertices[some_index(random, vertices)];
      return {{(one.x + other.x) / 2 + random.between(-1, 1) / 2.0, other.y}, vertices};
    }};

inline constexpr Layout boundary{"boundary", "in whole numbers: the point is on a side or at a vertex", true,
                                 [](Random& random) -> PolygonCase {
                                   const Outline vertices = whole_outline(random);
                                   const double share = random.one_in(3) ? 0 : random.between(1, 7) / 8.0;
                                   return {on_a_side(random, vertices, share), vertices};
                                 }};

/// Levels whose distances are powers of two, so that a share of the way from one to another is exact.
[[nodiscard]] inline double some_level(Random& random) { return 4 * random.between(-1, 1); }

/// An outline whose vertices lie on three levels of y, and a third of the time on three of x.
[[nodiscard]] inline Outline on_levels(Random& random) {
  const bool both = random.one_in(3);
  Outline vertices;
  for (int k = random.between(3, 8); k > 0; --k) {
    const double x = both ? some_level(random) : random.between(-4, 4);
    vertices.push_back({x, some_level(random)});
  }
  return vertices;
}

inline constexpr Layout whole{
    "whole", "so short that little is rounded: on sides, at vertices, on a side's line, level with vertices",
    true, [](Random& random) -> PolygonCase {
      if (random.one_in(3)) return level.plan(random);
      const Outline vertices = on_levels(random);
      const int kind = random.between(0, 4);
      if (kind == 0) return {vertices[some_index(random, vertices)], vertices};
      if (kind == 1) return {on_a_side(random, vertices, random.between(0, 8) / 8.0), vertices};
      if (kind == 2) return {on_a_side(random, vertices, random.between(-4, 12) / 8.0), vertices};
      const double x = random.between(-6, 6) / 2.0;
      return {{x, kind == 3 ? some_level(random) : random.between(-6, 6) / 2.0}, vertices};
    }};

inline constexpr Layout near_boundary{
    "near_boundary", "the point is an ulp or so from a side or a vertex, or any small step from a side",
    false, [](Random& random) -> PolygonCase {
      const int count = vertex_count(random);
      const Outline vertices = star(random, count, random.one_in(3) ? 2 : 1);
      if (random.one_in(4)) return {on_a_side(random, vertices, 0), vertices};
      Vec2<double> point = on_a_side(random, vertices, random.unit());
      // Down to a double's last digits, which a float rounds away.
      if (random.one_in(2)) point.x += draw::magnitude<double>(random, -50, 0);
      return {point, vertices};
    }};

inline constexpr Layout self_crossing{
    "self_crossing", "the outline goes round several times and crosses itself", false, [](Random& random) {
      const int count = 4 + vertex_count(random);
      return with_point(star(random, count, random.between(2, 5)), [&] { return random.uniform(-5, 5); });
    }};

inline constexpr Layout repeated{
    "repeated", "in whole numbers: repeated vertices, collinear ones, sides that run back", true,
    [](Random& random) {
      return with_point(padded(random, scattered(random, random.between(3, 8), 3)),
                        [&] { return random.between(-6, 6) / 2.0; });
    }};

inline constexpr Layout no_area{
    "no_area", "in whole numbers: all vertices in a line or a point, or a bow tie of two equal halves", true,
    [](Random& random) -> PolygonCase {
      if (random.one_in(3)) {
        const double x = random.between(1, 6), y = random.between(1, 6);
        return with_point(turned(random, {{-x, -y}, {x, y}, {x, -y}, {-x, y}}),
                          [&] { return random.between(-4, 4) / 2.0; });
      }
      const Vec2<double> start = whole_place(random, 4), step = whole_place(random, 2);
      Outline vertices;
      for (int k = random.between(3, 8); k > 0; --k) {
        const double steps = random.between(-3, 3);
        vertices.push_back({start.x + steps * step.x, start.y + steps * step.y});
      }
      return {on_a_side(random, vertices, random.between(0, 8) / 8.0), vertices};
    }};

/// An everyday one, or one near the boundary.
[[nodiscard]] inline PolygonCase either_plan(Random& random) {
  return random.one_in(2) ? everyday.plan(random) : near_boundary.plan(random);
}

}  // namespace rayproof::outline_layout
