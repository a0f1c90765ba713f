#pragma once
/// \file
/// Outlines of polygons in the plane, and points to ask about; the polygons in space are made of them too.

#include <algorithm>
#include <numbers>
#include <rayproof/polygon.hpp>
#include <vector>

#include "generators/random.hpp"

namespace rayproof {

using Outline = std::vector<Vec2<double>>;

/// 3 to 24, now and then `many`.
[[nodiscard]] inline int vertex_count(Random& random, int many = 100) {
  return random.one_in(64) ? many : random.between(3, random.one_in(2) ? 8 : 24);
}

[[nodiscard]] inline Vec2<double> whole_place(Random& random, int size) {
  return {1.0 * random.between(-size, size), 1.0 * random.between(-size, size)};
}

/// A star around the origin: radii between 2 and 8, the angles ascending. With `turns` above 1 it goes round
/// several times and crosses itself.
[[nodiscard]] inline Outline star(Random& random, int count, int turns = 1) {
  Outline vertices;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * turns * (k + random.uniform(0, 0.8)) / count;
    const double radius = random.uniform(2, 8);
    vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return vertices;
}

/// Whole vertices anywhere on a small grid: level ones, collinear ones and repeated ones come by themselves.
[[nodiscard]] inline Outline scattered(Random& random, int count, int size) {
  Outline vertices;
  for (int k = 0; k < count; ++k) vertices.push_back(whole_place(random, size));
  return vertices;
}

/// A comb of whole vertices: concave, with horizontal and vertical sides, teeth of two heights.
[[nodiscard]] inline Outline comb(Random& random, int teeth) {
  Outline vertices;
  const bool square = random.one_in(2);
  const double left = -teeth;
  for (int k = 0; k < teeth; ++k) {
    const double x = left + 2 * k, top = random.between(2, 3);
    vertices.push_back({x, 0});
    vertices.push_back({x, top});
    if (square) vertices.push_back({x + 1, top});
    vertices.push_back({x + 1, 0});
  }
  vertices.push_back({left + 2 * teeth - 1, -2});
  vertices.push_back({left, -2});
  return vertices;
}

/// `vertices` with some repeated and some midpoints put in between.
[[nodiscard]] inline Outline padded(Random& random, const Outline& vertices) {
  Outline more;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Vec2<double> here = vertices[k], next = vertices[(k + 1) % vertices.size()];
    more.push_back(here);
    if (random.one_in(4)) more.push_back(here);
    if (random.one_in(4)) more.push_back({(here.x + next.x) / 2, (here.y + next.y) / 2});
  }
  return more;
}

/// The same outline with x and y exchanged half the time, and mirrored: no axis is special.
[[nodiscard]] inline Outline turned(Random& random, Outline vertices) {
  const bool exchange = random.one_in(2), mirror = random.one_in(2);
  for (Vec2<double>& v : vertices) {
    if (exchange) std::swap(v.x, v.y);
    if (mirror) v.y = -v.y;
  }
  return vertices;
}

[[nodiscard]] inline std::size_t some_index(Random& random, const Outline& vertices) {
  return static_cast<std::size_t>(random.between(0, static_cast<int>(vertices.size()) - 1));
}

/// A point on one of the sides, at this share of its length.
[[nodiscard]] inline Vec2<double> on_a_side(Random& random, const Outline& vertices, double share) {
  const std::size_t k = some_index(random, vertices);
  const Vec2<double> a = vertices[k], b = vertices[(k + 1) % vertices.size()];
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace rayproof
