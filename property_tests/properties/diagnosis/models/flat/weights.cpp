#include "properties/diagnosis/models/flat/weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/diagnosis/models/outlines/outline.hpp"

namespace rayproof::diagnosis {
namespace {

/// What the formula finds whose ray's way is taken from that point.
std::optional<TriangleHit> triangle_hit_from(const Case& one, const Triangle<double>& triangle,
                                             const glm::dvec3& start) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec3 b = triangle.b - triangle.a, c = triangle.c - triangle.a, way = ray.origin - start;
  const glm::dvec3 p = glm::cross(ray.direction, c), q = glm::cross(way, b), normal = glm::cross(b, c);
  const double size = glm::dot(b, p);
  if (size == 0) return std::nullopt;
  return TriangleHit{glm::dot(way, p) / size, glm::dot(ray.direction, q) / size, glm::dot(c, q) / size, size,
                     glm::dot(normal, normal)};
}

bool is_inside_along_normal(const FlatFigure& figure, const glm::dvec3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = figure.vertices.at(i), &to = figure.vertices.at((i + 1) % 3);
    if (glm::dot(figure.normal, glm::cross(to - from, point - from)) < 0) return false;
  }
  return true;
}

}  // namespace

std::optional<TriangleHit> triangle_hit(const Case& one) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  return triangle == nullptr ? std::nullopt : triangle_hit_from(one, *triangle, triangle->a);
}

Answers way_from_other_vertex(const Case& one, const Answer& /*exact*/) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  Answers answers;
  if (triangle == nullptr) return answers;
  for (const glm::dvec3& start : {triangle->b, triangle->c})
    if (const auto hit = triangle_hit_from(one, *triangle, start))
      answers.push_back(by_weights(one, *hit).front());
  return answers;
}

Answers fan_of_triangles(const Case& one, const Answer& /*exact*/) {
  const auto* polygon = shape_in<Polygon<double>>(one);
  if (polygon == nullptr) return {};
  const auto& v = polygon->vertices;
  std::optional<double> first, nearest;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const auto cut = with_question(one, [&](RayQuestion& asked) {
      asked.shape = Triangle<double>{v[0], v[i], v[i + 1]};
      return true;
    });
    const auto hit = cut.empty() ? std::nullopt : triangle_hit(cut.front());
    if (!hit || std::get<RayAnswer>(by_weights(cut.front(), *hit).front()).hits.count == 0) continue;
    if (!first) first = hit->t;
    nearest = std::min(hit->t, nearest.value_or(hit->t));
  }
  return first ? Answers{hit_at(one, *first, true).front(), hit_at(one, *nearest, true).front()}
               : Answers{RayAnswer{}};
}

Answers another_product(const Case& one, const Answer& /*exact*/) {
  using Number = double TriangleHit::*;
  static constexpr Number numbers[] = {&TriangleHit::beta, &TriangleHit::gamma, &TriangleHit::t};
  const auto hit = triangle_hit(one);
  Answers answers;
  if (!hit) return answers;
  for (const Number wrong : numbers) {
    TriangleHit mistaken = *hit;
    mistaken.*wrong = 0;
    answers.push_back(by_weights(one, mistaken).front());
    for (const Number other : numbers) {
      if (other == wrong) continue;
      mistaken.*wrong = (*hit).*other;
      answers.push_back(by_weights(one, mistaken).front());
    }
  }
  return answers;
}

Answers by_weights(const Case& one, const TriangleHit& hit) {
  return given_weights(one, hit, hit.beta >= 0 && hit.gamma >= 0 && hit.beta + hit.gamma <= 1);
}

Answers given_weights(const Case& one, const TriangleHit& hit, bool is_hit) {
  Answers answers = hit_at(one, hit.t, is_hit);
  auto& found = std::get<RayAnswer>(answers.front());
  if (found.hits.count > 0) found.barycentric = glm::dvec3(1 - hit.beta - hit.gamma, hit.beta, hit.gamma);
  return answers;
}

Answers determinant_without_sign(const Case& one, const Answer& /*exact*/) {
  const auto hit = triangle_hit(one);
  Answers answers;
  if (!hit) return answers;
  const TriangleHit turned{-hit->beta, -hit->gamma, -hit->t, hit->size, hit->area_squared};
  for (const bool is_turned : {hit->size<0, hit->size> 0})
    answers.push_back(by_weights(one, is_turned ? turned : *hit).front());
  return answers;
}

Answers edge_by_opposite_vertex(const Case& one, const Answer& /*exact*/) {
  const auto figure = shape_in<Triangle<double>>(one) == nullptr ? std::nullopt : flat_figure(one);
  const auto hit = figure ? plane_hit(one, *figure) : std::nullopt;
  Answers answers;
  if (!hit) return answers;
  const glm::dvec3 point = point_at(ray_in_object(*ray_question(one)), hit->t);
  for (std::size_t wrong = 0; wrong < 3; ++wrong) {
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 &from = figure->vertices[i], &to = figure->vertices[(i + 1) % 3];
      const glm::dvec3& start = i == wrong ? figure->vertices[(i + 2) % 3] : from;
      is_inside = is_inside && glm::dot(figure->normal, glm::cross(to - from, point - start)) >= 0;
    }
    answers.push_back(hit_at(one, hit->t, is_inside).front());
  }
  return answers;
}

Answers given_undivided(const Case& one, const Answer& exact) {
  const auto hit = triangle_hit(one);
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (!hit || answer == nullptr || !answer->barycentric) return {};
  Answers answers;
  // Where the signs are turned with the determinant's it is its magnitude.
  for (const double size : {hit->size, std::abs(hit->size)})
    for (const glm::dvec3& factors :
         {glm::dvec3(1, size, 1), glm::dvec3(1, 1, size), glm::dvec3(1, size, size), glm::dvec3(size)}) {
      RayAnswer wrong = *answer;
      wrong.barycentric = *answer->barycentric * factors;
      answers.emplace_back(wrong);
    }
  return answers;
}

Answers undivided(const Case& one, double TriangleHit::*weight) {
  const auto hit = triangle_hit(one);
  if (!hit) return {};
  TriangleHit changed = *hit;
  const double whole = changed.*weight *= hit->size;
  Answers answers = by_weights(one, changed);
  const double other = weight == &TriangleHit::beta ? hit->gamma : hit->beta;
  const bool is_hit = 0 <= whole && whole <= 1 && other >= 0 && hit->beta + hit->gamma <= 1;
  answers.push_back(given_weights(one, *hit, is_hit).front());
  return answers;
}

Answers weights_without_signs(const Case& one, const Answer& /*exact*/) {
  const auto hit = triangle_hit(one);
  return hit ? given_weights(one, *hit, std::abs(hit->beta) + std::abs(hit->gamma) <= 1) : Answers{};
}

Answers beyond_edge(const Case& one, int vertex) {
  const auto hit = triangle_hit(one);
  if (!hit) return {};
  std::array<double, 3> weights{1 - hit->beta - hit->gamma, hit->beta, hit->gamma};
  weights.at(static_cast<std::size_t>(vertex)) *= -1;
  return hit_at(one, hit->t, std::ranges::min(weights) >= 0);
}

Answers where_inside(const Case& one, TestedPoint point) {
  const auto figure = flat_figure(one);
  auto hit = figure ? plane_hit(one, *figure) : std::nullopt;
  if (!hit) return {};
  const glm::dvec3 tested = point(ray_in_object(*ray_question(one)), hit->t, figure->normal);
  hit->point = projected(tested, hit->axis);
  Answers answers;
  if (shape_in<Triangle<double>>(one) != nullptr)
    answers = hit_at(one, hit->t, is_inside_along_normal(*figure, tested));
  answers.push_back(hit_at(one, hit->t, is_inside_outline(*hit)).front());
  return answers;
}

}  // namespace rayproof::diagnosis
