#pragma once
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/plane/point_normal.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// Every coordinate of the vertices is a number.
template <Branching T>
[[nodiscard]] bool is_finite(const Polygon<T>& polygon) {
  return !polygon.vertices.empty() && rayproof::is_finite(polygon.vertices);
}

/// The base of the methods that differ in how they locate a point: a hit where the ray's point in the
/// polygon's plane, projected along the largest axis of the Newell normal, is inside the projected polygon or
/// on its boundary by `Locator::locate`, a method of point_in_polygon.
template <class Locator>
struct ByProjection {
  static constexpr Source source = Locator::source;

  template <Branching T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Polygon<T>& polygon) {
    if (!is_finite(polygon)) return no_hit<T>;
    step<T>(
        "Form the Newell normal",
        "n is the sum of the cross products of neighbouring vertices: perpendicular to the polygon, twice "
        "its area long.");
    const vec3<T> n = named("n", newell_normal<T>(polygon.vertices, nearest_the_origin(polygon.vertices)));
    const T t = plane::meet(ray, polygon.vertices.front(), n).lo;

    step<T>(steps::project_along_largest_axis);
    const LargestAxisLast<T> turned(n);
    PointAndPolygon<T> question{turned.dropped(point_at(ray, t)), {}};
    question.vertices.reserve(polygon.vertices.size());
    for (const vec3<T>& vertex : polygon.vertices) question.vertices.push_back(turned.dropped(vertex));
    return flat_hit(Locator::locate(question) != Position::outside, t, T(0), T(0));
  }
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
