#include "properties/edges.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "properties/trial.hpp"

namespace rayproof {

std::optional<Cube> cube_in(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  if (asked == nullptr) return std::nullopt;
  Ray<double> ray = ray_in_object(*asked);
  if (const auto* box = std::get_if<Box<double>>(&asked->shape)) return Cube{ray, box->min, box->max};
  const auto* solid = std::get_if<Parallelepiped<double>>(&asked->shape);
  if (solid == nullptr) return std::nullopt;
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(solid->edges[0], solid->edges[1], solid->edges[2]));
  ray.origin = inverse * (ray.origin - solid->corner);
  ray.direction = inverse * ray.direction;
  return Cube{ray, glm::dvec3(0), glm::dvec3(1)};
}

bool is_at_rim(const Case& one, double t, double share) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const auto* cylinder = asked == nullptr ? nullptr : std::get_if<Cylinder<double>>(&asked->shape);
  if (cylinder == nullptr || !cylinder->capped) return false;
  const glm::dmat4 map = glm::inverse(asked->transform.value_or(glm::dmat4(1)));
  const glm::dvec3 origin(map * glm::dvec4(asked->ray.origin, 1));
  const glm::dvec3 way = t * glm::dvec3(map * glm::dvec4(asked->ray.direction, 0));
  const glm::dvec3 place = origin + way;
  const double band = share * (glm::length(origin) + glm::length(way) + cylinder->height);
  const double x = place.x / cylinder->rx, y = place.y / cylinder->ry;
  const double beside_side = std::abs(x * x + y * y - 1) * std::min(cylinder->rx, cylinder->ry);
  return std::min(std::abs(place.z), std::abs(place.z - cylinder->height)) <= band && beside_side <= band;
}

bool is_at_edge(const Case& one, double t, double share) {
  const auto cube = cube_in(one);
  if (!cube) return is_at_rim(one, t, share);
  const glm::dvec3 way = t * cube->ray.direction, place = cube->ray.origin + way;
  int faces = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = cube->high[axis] - cube->low[axis];
    const double band = share * (std::abs(cube->ray.origin[axis]) + std::abs(way[axis]) + size);
    const double low = std::abs(place[axis] - cube->low[axis]),
                 high = std::abs(place[axis] - cube->high[axis]);
    faces += std::min(low, high) <= band && size > band ? 1 : 0;
  }
  return faces >= 2;
}

}  // namespace rayproof
