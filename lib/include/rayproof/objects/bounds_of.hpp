#pragma once
/// \file
/// The points whose convex hull holds a shape, for each shape that has an end, and the box around them.

#include <rayproof/box.hpp>
#include <rayproof/cylinder.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/objects/hull.hpp>
#include <rayproof/parallelepiped.hpp>
#include <rayproof/sphere.hpp>
#include <rayproof/triangle.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

inline void enclose(objects::Hull& hull, const Triangle<Bounded<double>>& triangle) {
  for (const auto& vertex : {triangle.a, triangle.b, triangle.c}) hull.add(vertex);
}

inline void enclose(objects::Hull& hull, const Sphere<Bounded<double>>& sphere) {
  const objects::BoundedPoint reach{sphere.radius, sphere.radius, sphere.radius};
  hull.add_box(sphere.center - reach, sphere.center + reach);
}

inline void enclose(objects::Hull& hull, const Box<Bounded<double>>& box) { hull.add_box(box.min, box.max); }

inline void enclose(objects::Hull& hull, const Cylinder<Bounded<double>>& cylinder) {
  hull.add_box({-cylinder.rx, -cylinder.ry, 0.0}, {cylinder.rx, cylinder.ry, cylinder.height});
}

inline void enclose(objects::Hull& hull, const Parallelepiped<Bounded<double>>& solid) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    objects::BoundedPoint p = solid.corner;
    for (unsigned edge = 0; edge < 3; ++edge)
      if ((corner >> edge & 1U) != 0) p = p + solid.edges[edge];
    hull.add(p);
  }
}

namespace objects {

/// How high the plane of a polygon may rise from its first vertex, over points that are no farther from it
/// than `reach` along the two other axes, if `axis` is the one that its projection drops; 0 where it is
/// certainly not that one.
[[nodiscard]] inline double rise_of(const BoundedPoint& normal, int axis, const glm::dvec3& reach) {
  constexpr double outwards = 1 + 0x1p-40;  // outweighs the roundings of these lines
  const auto along = [&](int i) { return i == 0 ? normal.x : i == 1 ? normal.y : normal.z; };
  const auto at_most = [&](int i) { return outwards * (std::abs(along(i).value) + along(i).error); };
  const auto at_least = [&](int i) {
    return std::max(0.0, std::abs(along(i).value) / outwards - outwards * along(i).error);
  };
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (at_most(axis) < std::max(at_least(x), at_least(y))) return 0;
  const auto over = [&](int other) {
    const double slope = at_least(axis) > 0 ? std::min(1.0, at_most(other) / at_least(axis)) : 1;
    return outwards * slope * reach[other];
  };
  return outwards * (over(x) + over(y));
}

}  // namespace objects

/// A polygon lies in its exact plane through the first vertex, from which the others may stand off: along the
/// axis that its projection drops, the box is as high as the plane rises over the other two.
inline void enclose(objects::Hull& hull, const Polygon<Bounded<double>>& polygon) {
  const auto plain = [](const objects::BoundedPoint& p) {
    return glm::dvec3(p.x.value, p.y.value, p.z.value);
  };
  if (polygon.vertices.empty()) return hull.give_up();
  const glm::dvec3 first = plain(polygon.vertices.front());
  objects::Bounds box{first, first};
  for (const auto& vertex : polygon.vertices) box = box.around({plain(vertex), plain(vertex)});
  const glm::dvec3 reach = glm::max(first - box.low, box.high - first);
  const auto normal = polygon::newell_normal<Bounded<double>>(polygon.vertices, polygon.vertices.front());
  for (int axis = 0; axis < 3; ++axis) {
    const Bounded<double> from(first[axis]), rise(objects::rise_of(normal, axis, reach));
    box.low[axis] = std::min(box.low[axis], objects::not_above(from - rise));
    box.high[axis] = std::max(box.high[axis], objects::not_below(from + rise));
  }
  hull.add_box(convert<Bounded<double>>(box.low), convert<Bounded<double>>(box.high));
}

namespace objects {

/// A box around a shape where its map puts it: no point of the exact shape lies outside it. Nothing for a
/// shape without end, or where a number is beyond 2^500, so that overflow can't spoil the proof.
template <template <class> class Shape, class T>
[[nodiscard]] std::optional<Bounds> bounds_of(const Shape<T>& shape,
                                              const std::optional<ObjectSpace<double>>& space) {
  if constexpr (requires(Hull & hull, const Shape<Bounded<double>>& exact) { enclose(hull, exact); }) {
    Hull hull(space);
    enclose(hull, convert<Bounded<double>>(shape));
    return hull.bounds();
  } else {
    return std::nullopt;
  }
}

}  // namespace objects
}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
