#include "properties/diagnosis/models/first_hit/surface_normals.hpp"

#include <cmath>

#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

/// From afar a hit is rounded to as much as that times more.
constexpr double from_afar = 32;

/// Of a box or parallelepiped, in the object's space: the normals of the faces on which p(t) lies.
std::vector<glm::dvec3> normals_of_faces(const Case& one, double t) {
  const Cube cube = *cube_in(one);
  glm::dmat3 normals(1);
  if (const auto* solid = shape_in<Parallelepiped<double>>(one))
    normals = glm::transpose(glm::inverse(glm::dmat3(solid->edges[0], solid->edges[1], solid->edges[2])));
  const double share = from_afar * share_of_rounding(one.precision);
  const glm::dvec3 way = t * cube.ray.direction, place = cube.ray.origin + way;
  std::vector<glm::dvec3> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = cube.high[axis] - cube.low[axis];
    const double band = share * (std::abs(cube.ray.origin[axis]) + std::abs(way[axis]) + size);
    if (std::abs(place[axis] - cube.low[axis]) <= band) faces.push_back(-normals[axis]);
    if (std::abs(place[axis] - cube.high[axis]) <= band) faces.push_back(normals[axis]);
  }
  return faces;
}

/// Of a cylinder's rim: that of the side and that of the cap.
std::vector<glm::dvec3> normals_of_rim(const Case& one, const Cylinder<double>& cylinder, double t) {
  const glm::dvec3 p = point_at(ray_in_object(*ray_question(one)), t);
  const double rx = cylinder.rx, ry = cylinder.ry;
  return {{p.x / (rx * rx), p.y / (ry * ry), 0}, {0, 0, p.z < cylinder.height / 2 ? -1 : 1}};
}

}  // namespace

std::vector<glm::dvec3> normals_of_first_hit(const Case& one, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || answer->hits.count == 0) return {};
  if (answer->normal) return {*answer->normal};
  const double t = answer->hits.t[0];
  std::vector<glm::dvec3> normals;
  if (cube_in(one))
    normals = normals_of_faces(one, t);
  else if (const auto* cylinder = shape_in<Cylinder<double>>(one))
    normals = normals_of_rim(one, *cylinder, t);
  for (glm::dvec3& normal : normals) normal = glm::normalize(map_of_normals(*ray_question(one)) * normal);
  return normals;
}

}  // namespace rayproof::diagnosis
