#include "properties/diagnosis/models/solid.hpp"

#include <cmath>

namespace rayproof::diagnosis {
namespace {

template <class DoChange>
std::vector<Case> with_sphere(const Case& one, DoChange&& change) {
  return with_shape<Sphere<double>>(one, [&](RayQuestion& /*asked*/, Sphere<double>& sphere) {
    change(sphere);
    return true;
  });
}

template <class DoChange>
std::vector<Case> with_cylinder(const Case& one, DoChange&& change) {
  return with_shape<Cylinder<double>>(one, [&](RayQuestion& /*asked*/, Cylinder<double>& cylinder) {
    change(cylinder);
    return true;
  });
}

/// The object moved along its own z axis.
void lift(RayQuestion& asked, double by) {
  glm::dmat4 map = asked.transform.value_or(glm::dmat4(1));
  map[3] += by * map[2];
  asked.transform = map;
}

/// Without the hits at which the ray passes the plane z = height of the object's space.
Answers without_hits_at(const Case& one, const Answer& exact, bool is_upper) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double t_cap = ((is_upper ? cylinder->height : 0) - ray.origin.z) / ray.direction.z;
  const auto& all = std::get<RayAnswer>(exact);
  const RayAnswer left = hits_where(
      all, [&](double t) { return !(std::abs(t - t_cap) <= 0x1p-16 * (std::abs(t) + std::abs(t_cap))); });
  return left.hits.count == all.hits.count ? Answers{} : Answers{left};
}

}  // namespace

std::vector<Case> radius_squared(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius *= sphere.radius; });
}
std::vector<Case> radius_rooted(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius = std::sqrt(sphere.radius); });
}
std::vector<Case> radius_doubled(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius *= 2; });
}
std::vector<Case> radius_halved(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.radius /= 2; });
}
std::vector<Case> sphere_at_zero(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.center = glm::dvec3(0); });
}
std::vector<Case> sphere_mirrored(const Case& one) {
  return with_sphere(one, [](Sphere<double>& sphere) { sphere.center = -sphere.center; });
}

std::vector<Case> parallelepiped_as_box(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* solid = std::get_if<Parallelepiped<double>>(&asked.shape);
    if (solid == nullptr) return false;
    const glm::dvec3 a = solid->corner;
    const glm::dvec3 b = a + solid->edges[0] + solid->edges[1] + solid->edges[2];
    asked.shape = Box<double>{glm::min(a, b), glm::max(a, b)};
    return true;
  });
}

std::vector<Case> endless_cylinder(const Case& one) {
  return with_shape<Cylinder<double>>(one, [](RayQuestion& asked, Cylinder<double>& cylinder) {
    const double half = 0x1p30 * std::max({cylinder.height, cylinder.rx, cylinder.ry});
    lift(asked, -half);
    cylinder.height = 2 * half;
    cylinder.capped = false;
    return true;
  });
}
std::vector<Case> with_caps(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.capped = true; });
}
std::vector<Case> without_caps(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.capped = false; });
}
std::vector<Case> circular_rx(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.ry = cylinder.rx; });
}
std::vector<Case> circular_ry(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.rx = cylinder.ry; });
}
std::vector<Case> radii_exchanged(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { std::swap(cylinder.rx, cylinder.ry); });
}
std::vector<Case> radii_squared(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) {
    cylinder.rx *= cylinder.rx;
    cylinder.ry *= cylinder.ry;
  });
}
std::vector<Case> middle_at_zero(const Case& one) {
  return with_shape<Cylinder<double>>(one, [](RayQuestion& asked, const Cylinder<double>& cylinder) {
    lift(asked, -cylinder.height / 2);
    return true;
  });
}

Answers no_lower_cap(const Case& one, const Answer& exact) { return without_hits_at(one, exact, false); }
Answers no_upper_cap(const Case& one, const Answer& exact) { return without_hits_at(one, exact, true); }

}  // namespace rayproof::diagnosis
