#pragma once
/// \file
/// Textbook code for rays and shapes with one fault each: what is the same for all shapes.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "unit/diagnosis/faulty/fault.hpp"

namespace rayproof::faulty {

/// The hits of the whole line, ascending, and the normal at each; in the object's space.
template <class T>
struct FoundHits {
  struct CodeHit {
    T t;
    glm::vec<3, T> normal;
    std::optional<glm::dvec3> barycentric{};
  };
  std::vector<CodeHit> hits{};
  Contact contact = Contact::none;
};

/// The ray as the code takes it into object space.
template <class T>
[[nodiscard]] Ray<T> object_ray(const RayQuestion& asked, Fault fault) {
  Ray<T> ray = convert<T>(asked.ray);
  if (!asked.transform || fault == Fault::ignores_transform) return ray;
  const glm::mat<4, 4, T> map(*asked.transform);
  const glm::mat<3, 3, T> inverse =
      fault == Fault::inverse_transform ? glm::mat<3, 3, T>(map) : glm::inverse(glm::mat<3, 3, T>(map));
  const glm::vec<3, T> moved(map[3]);
  if (fault == Fault::inverse_transform)
    return {inverse * ray.origin + moved, inverse * ray.direction, ray.t_min, ray.t_max};
  ray.origin = inverse * (fault == Fault::origin_not_translated ? ray.origin : ray.origin - moved);
  ray.direction = inverse * (fault == Fault::direction_translated ? ray.direction - moved : ray.direction);
  return ray;
}

/// The hits that count, in the order in which they are reported.
template <class T>
[[nodiscard]] std::vector<typename FoundHits<T>::CodeHit> counted(const FoundHits<T>& found,
                                                                  const Ray<T>& ray, Fault fault) {
  const auto counts = [&](T t) {
    if (fault == Fault::ignores_t_max) return ray.t_min <= t;
    if (fault == Fault::ignores_t_min) return t <= ray.t_max;
    if (fault == Fault::t_min_is_zero) return T(0) <= t && t <= ray.t_max;
    if (fault == Fault::open_interval) return ray.t_min < t && t < ray.t_max;
    if (fault == Fault::epsilon) return in_interval(ray, t) && t > T(1e-4);
    if (fault == Fault::limited) return in_interval(ray, t) && t < T(1e5);
    if (fault == Fault::segment) return T(0) <= t && t <= T(1);
    return in_interval(ray, t);
  };
  std::vector<typename FoundHits<T>::CodeHit> kept;
  bool any = false;
  for (const auto& hit : found.hits) any = any || counts(hit.t);
  for (const auto& hit : found.hits)
    if (counts(hit.t) || (fault == Fault::one_admits_all && any)) kept.push_back(hit);
  if (fault == Fault::behind_counts && !found.hits.empty() && found.hits.back().t < ray.t_min)
    return found.hits;
  if (fault == Fault::near_root_only && !found.hits.empty() && !counts(found.hits.front().t)) kept.clear();
  if (fault == Fault::far_root && kept.size() > 1) kept.erase(kept.begin());
  if (fault == Fault::descending && kept.size() > 1) std::swap(kept[0], kept[1]);
  return kept;
}

/// The normal that the code gives, in the world.
template <class T>
[[nodiscard]] glm::dvec3 world_normal(const RayQuestion& asked, const glm::vec<3, T>& normal, Fault fault) {
  const glm::mat<3, 3, T> map(asked.transform.value_or(glm::dmat4(1)));
  glm::vec<3, T> turned = glm::transpose(glm::inverse(map)) * normal;
  if (fault == Fault::normal_by_matrix) turned = map * normal;
  if (fault == Fault::normal_in_object) turned = normal;
  if (fault != Fault::normal_not_unit) turned = glm::normalize(turned);
  const bool is_flipped =
      fault == Fault::normal_flipped ||
      (fault == Fault::normal_faces_ray && glm::dot(glm::dvec3(turned), asked.ray.direction) > 0);
  return glm::dvec3(is_flipped ? -turned : turned);
}

/// The whole answer: `find(ray, fault)` finds the hits of the line in object space, with t in lengths of the
/// ray's direction.
template <class T, class Find>
[[nodiscard]] RayAnswer answered(const RayQuestion& asked, Fault fault, Find&& find) {
  const Ray<T> world = convert<T>(asked.ray);
  Ray<T> ray = object_ray<T>(asked, fault);
  const Ray<T> object = ray;
  if (fault == Fault::distance || fault == Fault::object_distance) {
    const T length = fault == Fault::distance ? glm::length(world.direction) : glm::length(ray.direction);
    ray.direction /= length;
  }
  RayAnswer answer;
  const FoundHits<T> found = find(ray, fault);
  answer.contact = found.contact;
  const auto hits = counted(found, world, fault);
  for (const auto& hit : hits) answer.hits.push_back(static_cast<double>(hit.t));
  if (hits.empty()) return answer;
  answer.contact = found.contact == Contact::tangent ? found.contact : Contact::crossing;
  const T t = hits.front().t;
  answer.point = glm::dvec3(fault == Fault::point_in_object ? point_at(object, t) : point_at(world, t));
  if (fault == Fault::point_without_origin) answer.point = glm::dvec3(t * world.direction);
  answer.normal = world_normal<T>(asked, hits.front().normal, fault);
  if (fault == Fault::point_at_foot)
    answer.point = asked.ray.origin - dot(asked.ray.origin - *answer.point, *answer.normal) * *answer.normal;
  answer.barycentric = hits.front().barycentric;
  if (answer.barycentric && fault == Fault::barycentric_order)
    std::swap(answer.barycentric->x, answer.barycentric->z);
  if (answer.barycentric && fault == Fault::barycentric_with_t)
    answer.barycentric = {answer.barycentric->y, answer.barycentric->z, answer.hits.t[0]};
  return answer;
}

}  // namespace rayproof::faulty
