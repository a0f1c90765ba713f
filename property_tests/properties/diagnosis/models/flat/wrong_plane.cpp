#include "properties/diagnosis/models/flat/wrong_plane.hpp"

#include "properties/diagnosis/models/outlines/outline.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {

Answers plane_through_zero(const Case& one, const Answer& /*exact*/) {
  const auto figure = flat_figure(one);
  auto hit = figure ? plane_hit(one, *figure) : std::nullopt;
  if (!hit) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  hit->t = -glm::dot(figure->normal, ray.origin) / glm::dot(figure->normal, ray.direction);
  hit->point = projected(point_at(ray, hit->t), hit->axis);
  return hit_at(one, hit->t, is_inside_outline(*hit));
}

Answers normal_is_no_cross_product(const Case& one, const Answer& /*exact*/) {
  const auto* plane = shape_in<ParametricPlane>(one);
  if (plane == nullptr) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  Answers answers;
  for (const glm::dvec3& normal : {plane->u + plane->v, plane->u - plane->v, plane->u, plane->v}) {
    const double slope = glm::dot(normal, ray.direction);
    const double t = glm::dot(normal, plane->point - ray.origin) / slope;
    answers.push_back(hit_at(one, t, slope != 0).front());
  }
  return answers;
}

}  // namespace rayproof::diagnosis
