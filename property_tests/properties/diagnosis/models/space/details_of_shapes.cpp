#include "properties/diagnosis/models/space/details_of_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "properties/diagnosis/models/first_hit/surface_normals.hpp"

namespace rayproof::diagnosis {
namespace {

/// The radii and the height of a sphere or a cylinder.
std::vector<double*> sizes_in(RayQuestion& asked) {
  if (auto* sphere = std::get_if<Sphere<double>>(&asked.shape)) return {&sphere->radius};
  if (auto* cylinder = std::get_if<Cylinder<double>>(&asked.shape))
    return {&cylinder->rx, &cylinder->ry, &cylinder->height};
  return {};
}

}  // namespace
Answers normal_along_edge(const Case& one, const Answer& exact) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  if (solid == nullptr) return {};
  return with_normal(one, exact, [&](const RayQuestion& asked, const glm::dvec3& normal) {
    const glm::dvec3 own = normal_in_object_space(asked, normal);
    const auto along = [&](const glm::dvec3& edge) { return glm::dot(edge, own) / glm::length(edge); };
    // The two other edges lie in the face.
    const glm::dvec3 edge =
        *std::ranges::max_element(solid->edges, {}, [&](const auto& e) { return std::abs(along(e)); });
    return map_of_normals(asked) * (std::copysign(1, along(edge)) * edge);
  });
}

Answers normals_exchanged(const Case& one, const Answer& exact, int first, int second) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  if (solid == nullptr) return {};
  const auto& e = solid->edges;
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(e[0], e[1], e[2])));
  return with_normal(one, exact, [&](const RayQuestion& asked, const glm::dvec3& normal) {
    const glm::dvec3 own = normal_in_object_space(asked, normal);
    for (const auto& [from, to] : {std::pair(first, second), {second, first}}) {
      const double cosine = glm::dot(glm::normalize(normals[from]), glm::normalize(own));
      if (std::abs(cosine) > 1 - 0x1p-20)
        return map_of_normals(asked) * (std::copysign(1, cosine) * normals[to]);
    }
    return normal;
  });
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

std::vector<Case> whole_sizes(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const std::vector<double*> sizes = sizes_in(asked);
    constexpr double largest = 2147483647;  // of 32 bits
    for (double* size : sizes) *size = std::min(std::trunc(*size), largest);
    return !sizes.empty();
  });
}

std::vector<Case> zero_size_as_one(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    std::vector<double*> sizes = sizes_in(asked);
    std::erase_if(sizes, [](const double* size) { return *size != 0; });
    for (double* size : sizes) *size = 1;
    return !sizes.empty();
  });
}

}  // namespace rayproof::diagnosis
