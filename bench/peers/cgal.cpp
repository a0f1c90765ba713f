/// \file
/// CGAL's kernel of exact predicates and inexact constructions, in double: CGAL::intersection of a ray with a
/// triangle and with a plane. t is read off the point along the direction's largest component.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <rayproof/plane/forms.hpp>

#include "bench/peers/peer.hpp"

namespace rayproof::report {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point_in_cgal(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
Kernel::Vector_3 vector_in_cgal(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

struct CgalRay {
  Kernel::Ray_3 ray;
  int axis;               ///< along which the direction is largest
  double start, advance;  ///< origin and direction there
};

/// `Object` is met; one that is degenerate can't be asked.
template <class Object>
struct InCgal {
  /// The second point of CGAL's ray is beyond the origin's size, so that rounding it turns the ray by little.
  [[nodiscard]] std::optional<CgalRay> prepared(const Ray<double>& ray) const {
    if (object.is_degenerate()) return {};
    const double ratio = glm::length(ray.origin) / glm::length(ray.direction);
    const glm::dvec3 along = std::exp2(std::ceil(std::log2(std::max(1.0, ratio)))) * ray.direction;
    int axis = 0;
    for (const int other : {1, 2})
      if (std::abs(ray.direction[other]) > std::abs(ray.direction[axis])) axis = other;
    return CgalRay{
        {point_in_cgal(ray.origin), vector_in_cgal(along)}, axis, ray.origin[axis], ray.direction[axis]};
  }
  [[nodiscard]] double nearest(const CgalRay& asked) const {
    const auto found = CGAL::intersection(asked.ray, object);
    if (!found) return infinity<double>;
    const auto* const point = boost::relaxed_get<Kernel::Point_3>(&*found);
    return point == nullptr ? infinity<double> : ((*point)[asked.axis] - asked.start) / asked.advance;
  }
  [[nodiscard]] static double t_of(const CgalRay& /*asked*/, double t) { return t; }

  Object object;
};

struct CgalTriangle : InCgal<Kernel::Triangle_3> {
  explicit CgalTriangle(const Triangle<double>& t)
      : InCgal{{point_in_cgal(t.a), point_in_cgal(t.b), point_in_cgal(t.c)}} {}
};

struct CgalPlane : InCgal<Kernel::Plane_3> {
  explicit CgalPlane(const Plane<double>& shape) : InCgal{in_cgal(shape)} {}
  [[nodiscard]] static Kernel::Plane_3 in_cgal(const Plane<double>& shape) {
    const auto [normal, d] = plane::as_implicit(shape);
    return {normal.x, normal.y, normal.z, d};
  }
};

}  // namespace

std::vector<PeerRoutine> cgal_peers() {
  return {peer_by<CgalTriangle, double, Triangle>("triangle", "cgal"),
          peer_by<CgalPlane, double, Plane>("plane", "cgal")};
}

}  // namespace rayproof::report
