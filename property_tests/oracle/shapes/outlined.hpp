#pragma once
/// \file
/// What triangle and polygon share: an outline of sides, which a ray must come near for its verdict to be in
/// doubt.

#include <span>

#include "oracle/geometry/locate.hpp"
#include "oracle/shapes/flat.hpp"

namespace rayproof::oracle {

/// The coordinates that are left where the axis of the normal's largest component is dropped (ties: the later
/// axis). It matters which where the corners are not quite in a plane. Notes a doubt of estimates that are
/// not enough.
template <class R>
struct Projection {
  int x = 0, y = 1;

  /// Along an axis.
  explicit Projection(int axis) : x(axis == 0 ? 1 : 0), y(axis == 2 ? 1 : 2) {}
  explicit Projection(const Vector<R>& normal) : Projection(largest_of(normal)) {}

  /// The axis that is dropped.
  [[nodiscard]] int axis() const { return 3 - x - y; }
  [[nodiscard]] PlanePoint<R> operator()(const Vector<R>& v) const { return {v[x], v[y]}; }
  [[nodiscard]] PlanePoint<R> operator()(const glm::dvec3& v) const { return {R(v[x]), R(v[y])}; }

 private:
  static int largest_of(const Vector<R>& normal) {
    const auto magnitude = [&](int axis) { return sign(normal[axis]) < 0 ? -normal[axis] : normal[axis]; };
    int largest = 0;
    for (const int axis : {1, 2})
      if (sign(magnitude(axis) - magnitude(largest)) >= 0) largest = axis;
    return largest;
  }
};

/// How a point of the outline's plane touches the shape by the even-odd rule; the point comes in the scale of
/// ObjectRay, times a positive weight.
template <class R>
[[nodiscard]] Contact locate_in_outline(const Vector<R>& point, const R& weight, const Projection<R>& project,
                                        const ObjectRay<R>& ray, std::span<const glm::dvec3> corners) {
  const auto projected = [&](const glm::dvec3& corner) { return project(corner); };
  return locate(project(point), ray.scaled(weight), corners, projected);
}

/// The largest distance of the corners from (0, 0, 0).
[[nodiscard]] inline long double farthest_of(std::span<const glm::dvec3> corners) {
  long double squared = 0;
  for (const glm::dvec3& corner : corners) squared = std::max(squared, squared_length_of(corner));
  return std::sqrt(squared);
}

/// A flat shape bounded by sides from corner to corner.
class OutlinedIntersection : public FlatIntersection {
 public:
  using FlatIntersection::FlatIntersection;

  /// How near the ray comes to a side, or one of its ends to the shape.
  [[nodiscard]] Scaled margin(bool may_merge) const override;

 protected:
  [[nodiscard]] Scaled position() const override { return Scaled(farthest_of(corners())); }

  /// The corners in the order of the sides, in the shape's own space.
  [[nodiscard]] virtual std::span<const glm::dvec3> corners() const = 0;
  [[nodiscard]] Contact located(const Vector<Ring>& point, const Ring& weight) const {
    return locate_in_outline(point, weight, Projection<Ring>(plane_normal()), ray(), corners());
  }

 private:
  /// A corner, seen from the ray's origin in the scale of ObjectRay, where it is projected onto the plane
  /// along the axis of the normal's largest component; times the size of that component, which makes it
  /// exact.
  [[nodiscard]] Vector<Ring> in_plane(const glm::dvec3& corner, const Ring& weight) const;
  [[nodiscard]] Ring weight_in_plane() const;
  /// The distance of p(t) from the shape in units of L(t), where its foot on the plane lies in it; endless
  /// beside it, where its sides are nearest, and where it has no area.
  [[nodiscard]] Scaled height_over_shape(double t) const;
};

}  // namespace rayproof::oracle
