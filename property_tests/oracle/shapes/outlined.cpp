#include "oracle/shapes/outlined.hpp"

#include <algorithm>

#include "oracle/geometry/clearance.hpp"

namespace rayproof::oracle {
Scaled OutlinedIntersection::margin(bool) const {
  const Scaled scale = approximate(ray().scale);
  const RayPart part{ray().direction,        question().ray.t_min,      question().ray.t_max,
                     scale * sizes().origin, scale * sizes().direction, weight_in_plane()};
  Scaled nearest = endless();
  Vector<Ring> from = in_plane(corners().back(), part.weight);
  for (const glm::dvec3& corner : corners()) {
    const Vector<Ring> to = in_plane(corner, part.weight);
    reduce(nearest, part.distance_to(from, to));
    from = to;
  }
  for (const double end : finite_ends(question().ray)) reduce(nearest, height_over_shape(end));
  return nearest;
}

Ring OutlinedIntersection::weight_in_plane() const {
  if (is_degenerate()) return Ring(1.0);
  const Ring& largest = plane_normal()[Projection<Ring>(plane_normal()).axis()];
  return sign(largest) < 0 ? -largest : largest;
}

Vector<Ring> OutlinedIntersection::in_plane(const glm::dvec3& corner, const Ring& weight) const {
  const Vector<Ring> seen = ray().scaled(Vector<Ring>::from(corner)) - ray().origin;
  Vector<Ring> moved = weight * seen;
  if (is_degenerate()) return moved;
  const int axis = Projection<Ring>(plane_normal()).axis();
  const Ring height = height_of(seen);
  Ring& along = axis == 0 ? moved.x : axis == 1 ? moved.y : moved.z;
  along = sign(plane_normal()[axis]) < 0 ? along + height : along - height;
  return moved;
}

Scaled OutlinedIntersection::height_over_shape(double t) const {
  const Vector<Ring>& normal = plane_normal();
  const Ring squared = dot(normal, normal), height = height_at(t);
  if (sign(squared) == 0) return endless();
  const Vector<Ring> foot = squared * (ray().origin + Ring(t) * ray().direction) - height * normal;
  if (located(foot, squared) == Contact::none) return endless();
  const Scaled reach = approximate(ray().scale) * sizes().reach(Scaled(t));
  return ratio(abs(approximate(height)), sqrt(approximate(squared)) * reach);
}

}  // namespace rayproof::oracle
