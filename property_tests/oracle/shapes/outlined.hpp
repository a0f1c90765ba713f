#pragma once
/// \file
/// What triangle and polygon share: an outline of sides, which a ray must come near for its verdict to be in
/// doubt.

#include <span>

#include "oracle/shapes/flat.hpp"

namespace rayproof::oracle {

/// A flat shape bounded by sides from corner to corner.
class OutlinedIntersection : public FlatIntersection {
 public:
  using FlatIntersection::FlatIntersection;

  /// How near the ray comes to a side, or one of its ends to the shape.
  [[nodiscard]] Scaled margin(bool may_merge) const override;

 protected:
  [[nodiscard]] Scaled position() const override;

  /// The corners in the order of the sides, in the shape's own space.
  [[nodiscard]] virtual std::span<const glm::dvec3> corners() const = 0;
  /// How a point of the plane touches the shape by the even-odd rule; the point comes times a positive
  /// weight.
  [[nodiscard]] Contact located(const Vector<Ring>& point, const Ring& weight) const;

 private:
  /// A corner, seen from the ray's origin in the scale of ObjectRay, where it is projected onto the plane.
  [[nodiscard]] Vector<Scaled> in_plane(const Vector<Ring>& corner) const;
  /// The distance of p(t) from the shape in units of L(t), where its foot on the plane lies in it; endless
  /// beside it, where its sides are nearest, and where it has no area.
  [[nodiscard]] Scaled height_over_shape(double t) const;
};

}  // namespace rayproof::oracle
