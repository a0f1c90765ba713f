#include "properties/diagnosis/models/first_hit/points.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

Answers with_point(const Answer& exact, const glm::dvec3& point) {
  RayAnswer other = std::get<RayAnswer>(exact);
  other.point = point;
  return {other};
}

}  // namespace

const RayAnswer* hit_with_point(const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  return answer != nullptr && answer->point ? answer : nullptr;
}

Answers point_in_object(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr || !ray_question(one)->transform) return {};
  return with_point(exact, point_at(ray_in_object(*ray_question(one)), answer->hits.t[0]));
}

Answers point_without_translation(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr || !ray_question(one)->transform) return {};
  return with_point(exact, *answer->point - glm::dvec3((*ray_question(one)->transform)[3]));
}

Answers point_without_origin(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  return answer == nullptr ? Answers{}
                           : with_point(exact, answer->hits.t[0] * ray_question(one)->ray.direction);
}

Answers point_against_direction(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  return answer == nullptr ? Answers{}
                           : with_point(exact, point_at(ray_question(one)->ray, -answer->hits.t[0]));
}

Answers point_by_unit_direction(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr) return {};
  Answers answers;
  for (const Ray<double>& ray : {ray_question(one)->ray, ray_in_object(*ray_question(one))}) {
    const double length = glm::length(ray.direction);  // in the world, or in object space
    answers.push_back(
        with_point(exact, point_at(ray_question(one)->ray, answer->hits.t[0] / length)).front());
  }
  return answers;
}

Answers point_from_shape(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  const auto place = answer == nullptr ? std::nullopt : some_point(ray_question(one)->shape);
  return place ? with_point(exact, *answer->point - *place) : Answers{};
}

Answers point_at_radius_one(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  const auto* sphere = answer == nullptr ? nullptr : shape_in<Sphere<double>>(one);
  if (sphere == nullptr || sphere->radius == 0) return {};
  const RayQuestion& asked = *ray_question(one);
  const glm::dvec3 own = point_at(ray_in_object(asked), answer->hits.t[0]) - sphere->center;
  const glm::dvec4 place(sphere->center + own / sphere->radius, 1);
  return with_point(exact, glm::dvec3(asked.transform.value_or(glm::dmat4(1)) * place));
}

Answers weights_on_grid(const Answer& exact, double cells) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->barycentric) return {};
  RayAnswer other = *answer;
  other.barycentric = glm::round(*answer->barycentric * cells) / cells;
  return {other};
}

std::optional<bool> point_on_grid(const Answer& got, const Answer& exact, double cells) {
  const auto* mine = std::get_if<RayAnswer>(&got);
  const RayAnswer* answer = hit_with_point(exact);
  if (mine == nullptr || answer == nullptr || !mine->point) return std::nullopt;
  const auto is_on_grid = [cells](const glm::dvec3& point) {
    bool is_on = true;
    for (int axis = 0; axis < 3; ++axis) is_on = is_on && on_grid(point[axis], cells) == point[axis];
    return is_on;
  };
  return is_on_grid(*answer->point) ? std::nullopt : std::optional(is_on_grid(*mine->point));
}

Answers weights_exchanged_along_axis(const Case& one, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  const auto figure = flat_figure(one);
  if (answer == nullptr || !answer->barycentric || !figure) return {};
  const glm::dvec3 size = glm::abs(figure->normal), &own = *answer->barycentric;
  Answers answers;
  for (int axis = 0; axis < 3; ++axis)
    for (const glm::dvec3& order :
         {glm::dvec3(own.y, own.x, own.z), glm::dvec3(own.z, own.y, own.x), glm::dvec3(own.x, own.z, own.y),
          glm::dvec3(own.y, own.z, own.x), glm::dvec3(own.z, own.x, own.y)}) {
      RayAnswer other = *answer;
      if (size[axis] > size[(axis + 1) % 3] && size[axis] > size[(axis + 2) % 3]) other.barycentric = order;
      answers.emplace_back(other);
    }
  return answers;
}

Answers point_at_radius(const Case& one, const Answer& exact) {
  const auto* sphere = hit_with_point(exact) == nullptr ? nullptr : shape_in<Sphere<double>>(one);
  return sphere == nullptr ? Answers{} : with_point(exact, point_at(ray_question(one)->ray, sphere->radius));
}

Answers point_at_direction(const Case& one, const Answer& exact) {
  return hit_with_point(exact) == nullptr ? Answers{}
                                          : with_point(exact, point_at(ray_question(one)->ray, 1.0));
}

Answers point_of_far_hit(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr || answer->hits.count < 2) return {};
  return with_point(exact, point_at(ray_question(one)->ray, answer->hits.t[1]));
}

Answers point_at_foot(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr || !answer->normal || topic_of(one) != "plane") return {};
  const glm::dvec3& origin = ray_question(one)->ray.origin;
  const double height = glm::dot(origin - *answer->point, *answer->normal);
  return with_point(exact, origin - height * *answer->normal);
}

std::optional<bool> point_moved_along_normal(const Case& one, const Answer& got, const Answer& exact) {
  const auto* mine = std::get_if<RayAnswer>(&got);
  const RayAnswer* answer = hit_with_point(exact);
  if (mine == nullptr || answer == nullptr || !mine->point || !answer->normal) return std::nullopt;
  const glm::dvec3 way = *mine->point - *answer->point;
  const double along = glm::dot(way, *answer->normal), far = size_of_scene(one);
  if (std::abs(along) <= 64 * share_of_rounding(one.precision) * far) return std::nullopt;
  for (const Answer& other : point_at_radius_one(one, exact))  // that says more
    if (glm::length(*mine->point - *std::get<RayAnswer>(other).point) <= 0x1p-6 * std::abs(along))
      return std::nullopt;
  return glm::length(way - along * *answer->normal) <= 0x1p-6 * std::abs(along);
}

std::optional<bool> point_beside_ray(const Case& one, const Answer& got, const Answer& exact) {
  const auto* mine = std::get_if<RayAnswer>(&got);
  if (mine == nullptr || !mine->point || !finds_something(exact)) return std::nullopt;
  const Ray<double>& ray = ray_question(one)->ray;
  const glm::dvec3 way = *mine->point - ray.origin, along = glm::normalize(ray.direction);
  const double apart = glm::length(way - glm::dot(way, along) * along);
  return apart > 0x1p-10 * std::max(size_of_scene(one), glm::length(*mine->point));
}

std::optional<bool> point_right_t_wrong(const Case& one, const Answer& got, const Answer& exact) {
  const auto* mine = std::get_if<RayAnswer>(&got);
  const RayAnswer* answer = hit_with_point(exact);
  if (mine == nullptr || answer == nullptr || !mine->point) return std::nullopt;
  if (mine->hits.count == 0 || are_close(one.precision, mine->hits.t[0], answer->hits.t[0], 0))
    return std::nullopt;
  return agree(one, got, exact, Aspect::point);
}

}  // namespace rayproof::diagnosis
