#include "properties/diagnosis/models/cylinders/normals.hpp"

#include <cmath>

#include "properties/diagnosis/models/first_hit/surface_normals.hpp"

namespace rayproof::diagnosis {
namespace {

/// Another normal, in the object's space, for one of the side's: `of_side(question, hit point, normal)`; and
/// for one of the caps': `of_cap(normal)`.
template <class OfSide, class OfCap>
Answers with_normal_of(const Case& one, const Answer& exact, OfSide&& of_side, OfCap&& of_cap) {
  if (shape_in<Cylinder<double>>(one) == nullptr) return {};
  return with_normal(one, exact, [&](const RayQuestion& asked, const glm::dvec3& normal) {
    const glm::dvec3 own = normal_in_object_space(asked, normal);
    const bool is_of_cap = std::abs(own.z) > 0x1p-10 * glm::length(own);
    const glm::dvec3 p = point_at(ray_in_object(asked), std::get<RayAnswer>(exact).hits.t[0]);
    return map_of_normals(asked) * (is_of_cap ? of_cap(own) : of_side(asked, p, own));
  });
}

glm::dvec3 as_it_is(const glm::dvec3& normal) { return normal; }
glm::dvec3 side_as_it_is(const RayQuestion& /*asked*/, const glm::dvec3& /*p*/, const glm::dvec3& normal) {
  return normal;
}

}  // namespace

Answers normal_of_circle(const Case& one, const Answer& exact) {
  const auto of_side = [](const RayQuestion& /*asked*/, const glm::dvec3& p, const glm::dvec3& /*normal*/) {
    return glm::dvec3(p.x, p.y, 0);
  };
  return with_normal_of(one, exact, of_side, as_it_is);
}

Answers normal_by_radii(const Case& one, const Answer& exact) {
  const auto of_side = [](const RayQuestion& asked, const glm::dvec3& p, const glm::dvec3& /*normal*/) {
    const auto& cylinder = std::get<Cylinder<double>>(asked.shape);
    return glm::dvec3(p.x / cylinder.rx, p.y / cylinder.ry, 0);
  };
  return with_normal_of(one, exact, of_side, as_it_is);
}

Answers normal_keeps_z(const Case& one, const Answer& exact) {
  const auto plain = [](const RayQuestion& /*asked*/, const glm::dvec3& p, const glm::dvec3& /*normal*/) {
    return p;
  };
  const auto in_radii = [](const RayQuestion& asked, const glm::dvec3& p, const glm::dvec3& /*normal*/) {
    const auto& cylinder = std::get<Cylinder<double>>(asked.shape);
    return glm::dvec3(p.x / (cylinder.rx * cylinder.rx), p.y / (cylinder.ry * cylinder.ry), p.z);
  };
  Answers answers = with_normal_of(one, exact, plain, as_it_is);
  for (Answer& other : with_normal_of(one, exact, in_radii, as_it_is)) answers.push_back(std::move(other));
  return answers;
}

Answers side_normal_faces_ray(const Case& one, const Answer& exact) {
  const auto of_side = [](const RayQuestion& asked, const glm::dvec3& /*p*/, const glm::dvec3& normal) {
    return glm::dot(normal, ray_in_object(asked).direction) > 0 ? -normal : normal;
  };
  return with_normal_of(one, exact, of_side, as_it_is);
}

Answers cap_normals_upward(const Case& one, const Answer& exact) {
  return with_normal_of(one, exact, side_as_it_is,
                        [](const glm::dvec3& normal) { return normal.z < 0 ? -normal : normal; });
}

Answers cap_normals_inward(const Case& one, const Answer& exact) {
  return with_normal_of(one, exact, side_as_it_is, [](const glm::dvec3& normal) { return -normal; });
}

}  // namespace rayproof::diagnosis
