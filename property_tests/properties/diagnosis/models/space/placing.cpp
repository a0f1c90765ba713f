#include "properties/diagnosis/models/space/placing.hpp"

#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/flat/flat.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

/// The case without its transform, once `change(shape, matrix)` has put its shape, an S, into the world.
template <class S, class DoChange>
std::vector<Case> placed(const Case& one, DoChange&& change) {
  return with_shape<S>(one, [&](RayQuestion& asked, const S& shape) {
    if (!asked.transform) return false;
    asked.shape = change(S(shape), *asked.transform);
    asked.transform.reset();
    return true;
  });
}

glm::dvec3 point_in(const glm::dmat4& matrix, const glm::dvec3& point) {
  return glm::dvec3(matrix * glm::dvec4(point, 1));
}

/// The upright box round the eight corners from + some of the edges.
Box<double> bounds_of(const glm::dmat4& matrix, const glm::dvec3& from,
                      const std::array<glm::dvec3, 3>& edges) {
  Box<double> box{point_in(matrix, from), point_in(matrix, from)};
  for (unsigned which = 1; which < 8; ++which) {
    glm::dvec3 corner = from;
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((which >> axis & 1U) != 0) corner += edges.at(axis);
    box.min = glm::min(box.min, point_in(matrix, corner));
    box.max = glm::max(box.max, point_in(matrix, corner));
  }
  return box;
}

}  // namespace

std::vector<Case> plane_normal_by_matrix(const Case& one) {
  const auto plane = implicit_form(one);
  if (!plane) return {};
  return with_question(one, [&](RayQuestion& asked) {
    if (!asked.transform) return false;
    const auto& [normal, d] = *plane;
    const glm::dvec3 foot = -d / glm::dot(normal, normal) * normal;
    const glm::dvec3 point = shape_in<ImplicitPlane>(one) != nullptr ? foot : point_of_plane(one);
    asked.shape = PointNormalPlane{point_in(*asked.transform, point), glm::dmat3(*asked.transform) * normal};
    asked.transform.reset();
    return true;
  });
}

std::vector<Case> with_transpose_for_inverse(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    if (!asked.transform) return false;
    const glm::dmat4 map = *asked.transform;
    asked.transform = glm::dmat4(glm::inverse(glm::transpose(glm::dmat3(map))));
    (*asked.transform)[3] = map[3];
    return true;
  });
}

std::vector<Case> with_uniform_scale(const Case& one) {
  std::vector<Case> all;
  for (int axis = 0; axis < 5; ++axis)
    for (const Case& some : placed<Sphere<double>>(one, [&](const auto&sphere, const glm::dmat4&matrix) {
           const glm::dvec3 scale(glm::length(matrix[0]), glm::length(matrix[1]), glm::length(matrix[2]));
           const double mean = axis == 3 ? (scale.x + scale.y + scale.z) / 3
                                         : std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix))));
           const double factor = axis < 3 ? scale[axis] : mean;
           return Sphere<double>{point_in(matrix, sphere.center), factor * sphere.radius};
         }))
      all.push_back(some);
  return all;
}

std::vector<Case> bounds_in_world(const Case& one) {
  auto of_box = placed<Box<double>>(one, [](const Box<double>& box, const glm::dmat4& matrix) {
    const glm::dvec3 size = box.max - box.min;
    return bounds_of(matrix, box.min,
                     {glm::dvec3(size.x, 0, 0), glm::dvec3(0, size.y, 0), glm::dvec3(0, 0, size.z)});
  });
  if (!of_box.empty()) return of_box;
  return placed<Parallelepiped<double>>(one, [](const auto& solid, const glm::dmat4& matrix) {
    return bounds_of(matrix, solid.corner, solid.edges);
  });
}

std::vector<Case> between_two_corners(const Case& one) {
  return placed<Box<double>>(one, [](const Box<double>& box, const glm::dmat4& matrix) {
    const glm::dvec3 a = point_in(matrix, box.min), b = point_in(matrix, box.max);
    return Box<double>{glm::min(a, b), glm::max(a, b)};
  });
}

std::vector<Case> corner_not_moved(const Case& one) {
  return placed<Parallelepiped<double>>(one, [](auto solid, const glm::dmat4& matrix) {
    for (glm::dvec3& edge : solid.edges) edge = glm::dmat3(matrix) * edge;
    return solid;
  });
}

std::vector<Case> edges_translated(const Case& one) {
  return placed<Parallelepiped<double>>(one, [](auto solid, const glm::dmat4& matrix) {
    solid.corner = point_in(matrix, solid.corner);
    for (glm::dvec3& edge : solid.edges) edge = point_in(matrix, edge);
    return solid;
  });
}

Answers beyond_bounding_sphere(const Case& one, const Answer& exact) {
  const auto figure = flat_figure(one);
  const RayQuestion* asked = ray_question(one);
  if (!figure || !asked->transform || !finds_something(exact)) return {};
  const glm::dmat4& matrix = *asked->transform;
  glm::dvec3 low = figure->vertices.front(), high = low;
  for (const glm::dvec3& vertex : figure->vertices)
    low = glm::min(low, vertex), high = glm::max(high, vertex);
  const glm::dvec3 middle = (low + high) / 2.0, centre = point_in(matrix, middle);
  double radius = 0;
  for (const glm::dvec3& vertex : figure->vertices) radius = std::max(radius, glm::length(vertex - middle));
  radius *= std::max({glm::length(matrix[0]), glm::length(matrix[1]), glm::length(matrix[2])});
  const glm::dvec3 &d = asked->ray.direction, way = centre - asked->ray.origin;
  const double nearest = std::max(0.0, glm::dot(way, d) / glm::dot(d, d));
  return glm::length(way - nearest * d) > radius ? Answers{RayAnswer{}} : Answers{};
}

}  // namespace rayproof::diagnosis
