#include "properties/diagnosis/models/details_of_shapes.hpp"

#include <array>
#include <cmath>

namespace rayproof::diagnosis {
namespace {

/// The exact first hit, where it has a normal.
const RayAnswer* hit_with_normal(const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  return answer != nullptr && answer->normal ? answer : nullptr;
}

/// How normals are taken from the object to the world.
glm::dmat3 map_of_normals(const RayQuestion& asked) {
  return glm::inverse(glm::transpose(glm::dmat3(asked.transform.value_or(glm::dmat4(1)))));
}

/// The answers with each of these, in the object's space, for a normal.
Answers with_normals(const Case& one, const RayAnswer& hit, std::initializer_list<glm::dvec3> normals) {
  Answers answers;
  for (const glm::dvec3& normal : normals) {
    if (normal == glm::dvec3(0)) continue;
    RayAnswer other = hit;
    other.normal = glm::normalize(map_of_normals(*ray_question(one)) * normal);
    answers.emplace_back(other);
  }
  return answers;
}

}  // namespace

Answers normal_keeps_z(const Case& one, const Answer& exact) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  const RayAnswer* hit = hit_with_normal(exact);
  if (cylinder == nullptr || hit == nullptr) return {};
  const glm::dvec3 own = glm::inverse(map_of_normals(*ray_question(one))) * *hit->normal;
  if (std::abs(own.z) > 0x1p-10 * glm::length(own)) return {};  // a cap's
  const glm::dvec3 p = point_at(ray_in_object(*ray_question(one)), hit->hits.t[0]);
  const double rx = cylinder->rx, ry = cylinder->ry;
  return with_normals(one, *hit, {p, {p.x / (rx * rx), p.y / (ry * ry), p.z}});
}

Answers normal_along_edge(const Case& one, const Answer& exact) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  const RayAnswer* hit = hit_with_normal(exact);
  if (solid == nullptr || hit == nullptr) return {};
  const glm::dvec3 own = glm::inverse(map_of_normals(*ray_question(one))) * *hit->normal;
  for (const glm::dvec3& edge : solid->edges) {
    const double along = glm::dot(edge, own) / (glm::length(edge) * glm::length(own));
    // The two other edges lie in the face.
    if (std::abs(along) > 0x1p-20) return with_normals(one, *hit, {std::copysign(1, along) * edge});
  }
  return {};
}

Answers point_by_other_weights(const Case& one, const Answer& exact) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  const auto* hit = std::get_if<RayAnswer>(&exact);
  if (triangle == nullptr || hit == nullptr || !hit->barycentric) return {};
  const glm::dmat4 matrix = ray_question(one)->transform.value_or(glm::dmat4(1));
  const glm::dvec3& w = *hit->barycentric;
  Answers answers;
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
    RayAnswer other = *hit;
    other.point =
        glm::dvec3(matrix * glm::dvec4(w[a] * triangle->a + w[b] * triangle->b + w[c] * triangle->c, 1));
    answers.emplace_back(other);
  }
  return answers;
}

}  // namespace rayproof::diagnosis
