#pragma once
/// \file
/// A point and a polygon in the plane, laid out for one difficulty each. The families of both polygon topics
/// are made of them. Where `exact`, all numbers are so short that nothing made of them is rounded.

#include "generators/draw.hpp"
#include "generators/outline.hpp"

namespace rayproof::outline_layout {

using Plan = PointAndPolygon<double>;

/// An outline of whole vertices, of any kind.
[[nodiscard]] inline Outline whole_outline(Random& random) {
  switch (random.between(0, 3)) {
    case 0:
      return turned(random, comb(random, random.between(1, 6)));
    case 1:
      return padded(random, scattered(random, random.between(3, 8), 4));
    case 2:
      return scattered(random, vertex_count(random), 8);
    default:
      return scattered(random, random.between(3, 8), 4);
  }
}

struct Everyday {
  static constexpr const char* name = "random";
  static constexpr const char* description =
      "a star of 3 to 24 corners, seldom more; about half the points inside";
  static constexpr bool exact = false;

  [[nodiscard]] static Plan plan(Random& random) {
    const Outline vertices = star(random, vertex_count(random));
    const double x = random.uniform(-5, 5);
    return {{x, random.uniform(-5, 5)}, vertices};
  }
};

struct Level {
  static constexpr const char* name = "level";
  static constexpr const char* description = "in whole numbers: the point is level with vertices and sides";
  static constexpr bool exact = true;

  [[nodiscard]] static Plan plan(Random& random) {
    const Outline vertices = whole_outline(random);
    const Vec2<double> one = some_vertex(random, vertices), other = some_vertex(random, vertices);
    return {{(one.x + other.x) / 2 + random.between(-1, 1) / 2.0, other.y}, vertices};
  }
};

struct Boundary {
  static constexpr const char* name = "boundary";
  static constexpr const char* description = "in whole numbers: the point is on a side or at a vertex";
  static constexpr bool exact = true;

  [[nodiscard]] static Plan plan(Random& random) {
    const Outline vertices = whole_outline(random);
    const double way = random.one_in(3) ? 0 : random.between(1, 7) / 8.0;
    return {on_a_side(random, vertices, way), vertices};
  }
};

struct NearBoundary {
  static constexpr const char* name = "near_boundary";
  static constexpr const char* description = "the point is an ulp or so from a side or a vertex";
  static constexpr bool exact = false;

  [[nodiscard]] static Plan plan(Random& random) {
    const int count = vertex_count(random);
    const Outline vertices = star(random, count, random.one_in(3) ? 2 : 1);
    return {on_a_side(random, vertices, random.one_in(4) ? 0 : random.unit()), vertices};
  }
};

struct Crossing {
  static constexpr const char* name = "self_crossing";
  static constexpr const char* description = "the outline goes round several times and crosses itself";
  static constexpr bool exact = false;

  [[nodiscard]] static Plan plan(Random& random) {
    const int count = 4 + vertex_count(random);
    const Outline vertices = star(random, count, random.between(2, 5));
    const double x = random.uniform(-5, 5);
    return {{x, random.uniform(-5, 5)}, vertices};
  }
};

struct Repeated {
  static constexpr const char* name = "repeated";
  static constexpr const char* description =
      "in whole numbers: repeated vertices, collinear ones, sides that run back";
  static constexpr bool exact = true;

  [[nodiscard]] static Plan plan(Random& random) {
    const Outline vertices = padded(random, scattered(random, random.between(3, 8), 3));
    const double x = random.between(-6, 6) / 2.0;
    return {{x, random.between(-6, 6) / 2.0}, vertices};
  }
};

struct NoArea {
  static constexpr const char* name = "no_area";
  static constexpr const char* description =
      "in whole numbers: all vertices in a line or a point, or a bow tie of two equal halves";
  static constexpr bool exact = true;

  [[nodiscard]] static Plan plan(Random& random) {
    Outline vertices;
    if (random.one_in(3)) {
      const double x = random.between(1, 6), y = random.between(1, 6);
      vertices = {{-x, -y}, {x, y}, {x, -y}, {-x, y}};
      vertices = turned(random, vertices);
      return {{random.between(-4, 4) / 2.0, random.between(-4, 4) / 2.0}, vertices};
    }
    const Vec2<double> start = whole_place(random, 4), way = whole_place(random, 2);
    for (int k = random.between(3, 8); k > 0; --k) {
      const double steps = random.between(-3, 3);
      vertices.push_back({start.x + steps * way.x, start.y + steps * way.y});
    }
    return {on_a_side(random, vertices, random.between(0, 8) / 8.0), vertices};
  }
};

struct Far {
  static constexpr const char* name = "far";
  static constexpr const char* description =
      "point and polygon are 1e2 to 1e6 sizes from the origin, half the time near the boundary";
  static constexpr bool exact = false;

  [[nodiscard]] static Plan plan(Random& random) {
    Plan plan = random.one_in(2) ? Everyday::plan(random) : NearBoundary::plan(random);
    const double distance = std::pow(10, random.uniform(2, 6));
    const double x = distance * draw::symmetric<double>(random);
    const double y = distance * draw::symmetric<double>(random);
    const auto move = [&](Vec2<double>& v) { v = {v.x + x, v.y + y}; };
    move(plan.point);
    for (Vec2<double>& vertex : plan.vertices) move(vertex);
    return plan;
  }
};

}  // namespace rayproof::outline_layout
