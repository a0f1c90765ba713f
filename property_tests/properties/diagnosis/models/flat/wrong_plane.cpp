#include "properties/diagnosis/models/flat/wrong_plane.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
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

namespace {

/// The answers of planes through that point with these normals.
Answers by_normals(const Case& one, const glm::dvec3& point, std::initializer_list<glm::dvec3> normals) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  Answers answers;
  for (const glm::dvec3& normal : normals) {
    const double slope = glm::dot(normal, ray.direction);
    const double t = glm::dot(normal, point - ray.origin) / slope;
    answers.push_back(hit_at(one, t, slope != 0).front());
  }
  return answers;
}

}  // namespace

Answers normal_is_no_cross_product(const Case& one, const Answer& /*exact*/) {
  const auto* plane = shape_in<ParametricPlane>(one);
  if (plane == nullptr) return {};
  const auto& [point, u, v] = *plane;
  return by_normals(one, point, {u + v, u - v, u, v});
}

Answers vectors_as_points(const Case& one, const Answer& /*exact*/) {
  const auto* plane = shape_in<ParametricPlane>(one);
  if (plane == nullptr) return {};
  const auto& [point, u, v] = *plane;
  const glm::dvec3 from_u = u - point, from_v = v - point;
  return by_normals(one, point, {glm::cross(from_u, from_v), glm::cross(u, from_v), glm::cross(from_u, v)});
}

Answers patch_of_plane(const Case& one, const Answer& exact) {
  const auto* plane = shape_in<ParametricPlane>(one);
  if (plane == nullptr || !finds_something(exact)) return {};
  const auto& [point, u, v] = *plane;
  const double t = std::get<RayAnswer>(exact).hits.t[0];
  const glm::dvec3 normal = glm::cross(u, v), way = point_at(ray_in_object(*ray_question(one)), t) - point;
  const double square = glm::dot(normal, normal);
  const double along_u = glm::dot(glm::cross(way, v), normal) / square;
  const double along_v = glm::dot(glm::cross(u, way), normal) / square;
  if (!std::isfinite(along_u) || !std::isfinite(along_v)) return {};  // beyond what doubles hold
  Answers answers;
  // The widest first: of limits that explain as much it is the one.
  for (const auto& [least, most] :
       {std::pair(-1000.0, 1000.0), {-100, 100}, {-10, 10}, {-2, 2}, {-1, 1}, {0, 1}}) {
    const bool is_in = least <= std::min(along_u, along_v) && std::max(along_u, along_v) <= most;
    answers.push_back(is_in ? exact : Answer{RayAnswer{}});
  }
  return answers;
}

std::optional<bool> skewed_is_missed(const Case& one, const Answer& got, const Answer& exact) {
  constexpr double small_angle = 0.25;
  const auto* plane = shape_in<ParametricPlane>(one);
  if (plane == nullptr || finds_something(got) || !finds_something(exact)) return std::nullopt;
  const double area = glm::length(glm::cross(plane->u, plane->v));
  return area <= small_angle * glm::length(plane->u) * glm::length(plane->v);
}

Answers constant_without_cosine(const Case& one, const Answer& /*exact*/) {
  const auto* plane = shape_in<PointNormalPlane>(one);
  if (plane == nullptr) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const auto& [point, normal] = *plane;
  const double slope = glm::dot(normal, ray.direction);
  const double constant = glm::length(normal) * glm::length(point);
  return hit_at(one, (constant - glm::dot(normal, ray.origin)) / slope, slope != 0);
}

namespace {

/// Where the line meets the plane through the mean of a polygon's vertices; nothing where it does not.
std::optional<PlaneHit> hit_through_mean(const Case& one) {
  const auto figure = shape_in<Polygon<double>>(one) == nullptr ? std::nullopt : flat_figure(one);
  auto hit = figure ? plane_hit(one, *figure) : std::nullopt;
  if (!hit) return hit;
  const glm::dvec3 mean = mean_of(figure->vertices);
  const Ray<double> ray = ray_in_object(*ray_question(one));
  hit->t = glm::dot(figure->normal, mean - ray.origin) / glm::dot(figure->normal, ray.direction);
  hit->point = projected(point_at(ray, hit->t), hit->axis);
  return hit;
}

}  // namespace

Answers plane_through_mean(const Case& one, const Answer& /*exact*/) {
  const auto hit = hit_through_mean(one);
  return hit ? hit_at(one, hit->t, is_inside_outline(*hit)) : Answers{};
}

Answers point_on_plane_through_mean(const Case& one, const Answer& exact) {
  const auto hit = hit_through_mean(one);
  if (!hit || !finds_something(exact)) return {};
  RayAnswer other = std::get<RayAnswer>(exact);
  other.point = point_at(ray_question(one)->ray, hit->t);
  return {other};
}

Answers projected_along_two_axes(const Case& one, const Answer& /*exact*/) {
  const auto figure = flat_figure(one);
  const auto hit = figure ? plane_hit(one, *figure) : std::nullopt;
  if (!hit) return {};
  const glm::dvec3 point = point_at(ray_in_object(*ray_question(one)), hit->t);
  const auto seen = [](const glm::dvec3& p, int axis, bool is_in_order) {
    const glm::dvec2 left = projected(p, axis);
    return is_in_order && axis == 1 ? glm::dvec2(left.y, left.x) : left;
  };
  Answers answers;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_in_order : {false, true})
      for (const auto& [of_point, of_vertices] : {std::pair(axis, hit->axis), std::pair(hit->axis, axis)}) {
        PlaneHit other{hit->t, seen(point, of_point, is_in_order), {}, hit->axis};
        for (const glm::dvec3& vertex : figure->vertices)
          other.vertices.push_back(seen(vertex, of_vertices, is_in_order));
        answers.push_back(hit_at(one, hit->t, is_inside_outline(other)).front());
      }
  return answers;
}

Answers newell_wrong(const Case& one, const Answer& /*exact*/) {
  const auto figure = shape_in<Polygon<double>>(one) == nullptr ? std::nullopt : flat_figure(one);
  Answers answers;
  if (!figure) return answers;
  const auto& all = figure->vertices;
  for (int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (const double sign : {1, -1}) {
      FlatFigure other = *figure;
      other.normal[axis] = 0;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::dvec3 &from = all[i], &to = all[(i + 1) % all.size()];
        other.normal[axis] += (from[b] + sign * to[b]) * (from[c] + sign * to[c]);
      }
      const auto hit = plane_hit(one, other);
      answers.push_back(hit ? hit_at(one, hit->t, is_inside_outline(*hit)).front() : RayAnswer{});
    }
  }
  return answers;
}

}  // namespace rayproof::diagnosis
