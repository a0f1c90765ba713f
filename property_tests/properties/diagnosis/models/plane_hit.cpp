#include "properties/diagnosis/models/plane_hit.hpp"

#include <algorithm>
#include <cmath>

namespace rayproof::diagnosis {
namespace {

int largest_axis_of(const glm::dvec3& normal) {
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (std::abs(normal[other]) >= std::abs(normal[axis])) axis = other;
  return axis;
}

}  // namespace

glm::dvec2 projected(const glm::dvec3& point, int axis) {
  return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}

namespace {

/// The figure with any normal, 0 where it has no area.
std::optional<FlatFigure> some_figure(const Case& one) {
  FlatFigure figure{};
  if (const auto* triangle = shape_in<Triangle<double>>(one))
    figure.vertices = {triangle->a, triangle->b, triangle->c};
  else if (const auto* polygon = shape_in<Polygon<double>>(one))
    figure.vertices = polygon->vertices;
  else
    return std::nullopt;
  const std::size_t count = figure.vertices.size();
  const glm::dvec3 first = figure.vertices.front();
  for (std::size_t i = 0; i < count; ++i)
    figure.normal += glm::cross(figure.vertices[i] - first, figure.vertices[(i + 1) % count] - first);
  return figure;
}

}  // namespace

std::optional<FlatFigure> flat_figure(const Case& one) {
  auto figure = some_figure(one);
  return figure && figure->normal != glm::dvec3(0) ? figure : std::nullopt;
}

std::optional<FlatFigure> figure_of_corner(const Case& one) {
  auto figure = shape_in<Polygon<double>>(one) == nullptr ? std::nullopt : some_figure(one);
  if (figure) figure->normal = normal_of_corner(figure->vertices);
  return figure;
}

bool lies_in_a_plane(const Case& one) {
  return shape_in<ImplicitPlane>(one) != nullptr || shape_in<PointNormalPlane>(one) != nullptr ||
         shape_in<ParametricPlane>(one) != nullptr || flat_figure(one).has_value();
}

std::optional<PlaneHit> plane_hit(const Case& one, const FlatFigure& figure) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double slope = glm::dot(figure.normal, ray.direction);
  if (slope == 0) return std::nullopt;
  const double t = glm::dot(figure.normal, figure.vertices.front() - ray.origin) / slope;
  const int axis = largest_axis_of(figure.normal);
  PlaneHit hit{t, projected(point_at(ray, t), axis), {}, axis};
  for (const glm::dvec3& vertex : figure.vertices) hit.vertices.push_back(projected(vertex, axis));
  return hit;
}

std::optional<PlaneHit> plane_hit(const Case& one) {
  const auto figure = flat_figure(one);
  return figure ? plane_hit(one, *figure) : std::nullopt;
}

namespace {

/// How far the vertices lie apart along an axis.
double extent(const FlatFigure& figure, int axis) {
  const auto [least, most] = std::ranges::minmax_element(
      figure.vertices, [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
  return (*most)[axis] - (*least)[axis];
}

}  // namespace

Answers projected_wrongly(const Case& one, WrongAxis wrong, bool is_hit) {
  const auto figure = flat_figure(one);
  const auto hit = plane_hit(one);
  if (!figure || !hit) return {};
  const glm::dvec3& n = figure->normal;
  const auto is_preferred = [&](int a, int b) {
    if (wrong == WrongAxis::least_extent) return extent(*figure, a) < extent(*figure, b);
    return wrong == WrongAxis::smallest ? std::abs(n[a]) < std::abs(n[b]) : n[a] > n[b];
  };
  int axis = static_cast<int>(wrong);
  if (wrong > WrongAxis::z) axis = is_preferred(1, 0) ? 1 : 0;
  if (wrong > WrongAxis::z && is_preferred(2, axis)) axis = 2;
  if (std::abs(n[axis]) > 0x1p-20 * glm::length(n)) return {};
  return hit_at(one, hit->t, is_hit);
}

Answers triangle_of_wrong_constant(const Case& one, const Answer& /*exact*/) {
  const auto figure = flat_figure(one);
  if (!figure || figure->vertices.size() != 3 || shape_in<Triangle<double>>(one) == nullptr) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double slope = glm::dot(figure->normal, ray.direction);
  if (slope == 0) return {};
  const double t = glm::dot(figure->normal, figure->vertices[0] + ray.origin) / slope;
  const glm::dvec3 p = point_at(ray, t);
  bool is_inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = figure->vertices[i], &to = figure->vertices[(i + 1) % 3];
    is_inside = is_inside && glm::dot(figure->normal, glm::cross(to - from, p - from)) >= 0;
  }
  return hit_at(one, t, is_inside);
}

Answers hit_at(const Case& one, double t, bool is_hit) {
  RayAnswer answer;
  if (is_hit && in_interval(ray_question(one)->ray, t)) answer.hits.push_back(t);
  return {answer};
}

}  // namespace rayproof::diagnosis
