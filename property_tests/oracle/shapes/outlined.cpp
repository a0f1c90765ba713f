#include "oracle/shapes/outlined.hpp"

#include <algorithm>

#include "oracle/geometry/clearance.hpp"

namespace rayproof::oracle {
Scaled OutlinedIntersection::margin(bool) const {
  const Scaled scale = approximate(ray().scale);
  const RayPart part{approximate(ray().direction), question().ray.t_min, question().ray.t_max,
                     scale * sizes().origin, scale * sizes().direction};
  const auto seen = [&](const glm::dvec3& corner) {
    return in_plane(ray().scale * Vector<Ring>::from(corner) - ray().origin);
  };
  Scaled nearest = endless();
  Vector<Scaled> from = seen(corners().back());
  for (const glm::dvec3& corner : corners()) {
    const Vector<Scaled> to = seen(corner);
    reduce(nearest, part.distance_to(from, to));
    from = to;
  }
  for (const double end : finite_ends(question().ray)) reduce(nearest, height_over_shape(end));
  return nearest;
}

Vector<Scaled> OutlinedIntersection::in_plane(const Vector<Ring>& corner) const {
  Vector<Scaled> seen = approximate(corner);
  const Ring height = height_of(corner);
  if (is_degenerate() || sign(height) == 0) return seen;
  const int axis = Projection<Ring>(plane_normal()).axis();
  Scaled& along = axis == 0 ? seen.x : axis == 1 ? seen.y : seen.z;
  along = along - approximate(height) / approximate(plane_normal()[axis]);
  return seen;
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
