#include "properties/diagnosis/models/solids/faces.hpp"

#include <algorithm>
#include <cmath>

#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

using Solid = Parallelepiped<double>;

FacePoint face_point(const glm::dvec3& way, const glm::dvec3& e, const glm::dvec3& f) {
  const double ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
  const double along = glm::dot(way, e), across = glm::dot(way, f), determinant = ee * ff - ef * ef;
  return {(along * ff - across * ef) / determinant,
          (across * ee - along * ef) / determinant,
          along,
          across,
          std::sqrt(ee),
          std::sqrt(ff),
          determinant};
}

template <class DoChange>
std::vector<Case> with_solid(const Case& one, DoChange&& change) {
  return with_shape<Solid>(one, [&](RayQuestion& /*asked*/, Solid& solid) {
    change(solid);
    return true;
  });
}

double triple_product(const Solid& solid) {
  return glm::dot(solid.edges[0], glm::cross(solid.edges[1], solid.edges[2]));
}

/// The parallelepiped of the case, or its box as one.
std::optional<Solid> solid_of(const Case& one) {
  if (const auto* solid = shape_in<Solid>(one)) return *solid;
  const auto* box = shape_in<Box<double>>(one);
  return box == nullptr ? std::nullopt : std::optional(as_parallelepiped(*box));
}

}  // namespace

Answers hits_of_faces(const Case& one, bool (*is_inside)(const FacePoint& point)) {
  const auto solid = solid_of(one);
  if (!solid) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  std::vector<double> all;
  const glm::dvec3* const e = solid->edges.data();
  for (std::size_t i = 0; i < 3; ++i)
    for (const double side : {0.0, 1.0}) {
      const glm::dvec3 &u = e[(i + 1) % 3], &v = e[(i + 2) % 3];
      const glm::dvec3 normal = glm::cross(u, v), corner = solid->corner + side * e[i];
      const double t = glm::dot(normal, corner - ray.origin) / glm::dot(normal, ray.direction);
      if (is_inside(face_point(point_at(ray, t) - corner, u, v))) all.push_back(t);
    }
  std::ranges::sort(all);
  RayAnswer first_two, ends;
  for (const double t : all)
    if (in_interval(ray, t) && first_two.hits.count < 2) first_two.hits.push_back(t);
  if (all.size() < 3) return {first_two};
  for (const double t : {all.front(), all.back()})
    if (in_interval(ray, t)) ends.hits.push_back(t);
  return {first_two, ends};
}

std::optional<double> volume(const Case& one) {
  const auto* solid = shape_in<Solid>(one);
  return solid == nullptr ? std::nullopt : std::optional(triple_product(*solid));
}

std::optional<double> length_in_edges(const Case& one) {
  const auto* solid = shape_in<Solid>(one);
  if (solid == nullptr) return std::nullopt;
  const auto& [x, y, z] = solid->edges;
  return glm::length(glm::inverse(glm::dmat3(x, y, z)) * ray_in_object(*ray_question(one)).direction);
}

std::vector<Case> edges_over_volume(const Case& one) {
  return with_solid(one, [](Solid& solid) {
    const double size = triple_product(solid);
    for (glm::dvec3& edge : solid.edges) edge /= size;
  });
}

std::vector<Case> edges_doubled(const Case& one) {
  return with_solid(one, [](Solid& solid) {
    for (glm::dvec3& edge : solid.edges) edge *= 2;
  });
}

std::vector<Case> edges_halved(const Case& one) {
  return with_solid(one, [](Solid& solid) {
    for (glm::dvec3& edge : solid.edges) edge /= 2;
  });
}

std::vector<Case> corner_negated(const Case& one) {
  return with_solid(one, [](Solid& solid) { solid.corner = -solid.corner; });
}

std::vector<Case> edge_negated(const Case& one, std::size_t edge) {
  return with_solid(one, [edge](Solid& solid) { solid.edges.at(edge) *= -1; });
}

std::vector<Case> edges_both_ways(const Case& one) {
  return with_solid(one, [](Solid& solid) {
    for (glm::dvec3& edge : solid.edges) {
      solid.corner -= edge;
      edge *= 2;
    }
  });
}

}  // namespace rayproof::diagnosis
