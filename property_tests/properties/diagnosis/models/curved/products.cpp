#include "properties/diagnosis/models/curved/products.hpp"

#include <array>

#include "properties/diagnosis/models/curved/root_formula.hpp"
#include "properties/diagnosis/models/flat/flat.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

/// The product's values with the term so mistaken.
std::array<double, 8> wrong_values(const glm::dvec3& u, const glm::dvec3& v, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double others = u[i] * v[i] + u[j] * v[j], own = u[axis] * v[axis];
  return {others - own,
          others,
          others + u[axis] * v[i],
          others + u[axis] * v[j],
          others + u[i] * v[i],
          others + u[j] * v[j],
          others + u[i] * v[axis],
          others + u[j] * v[axis]};
}

/// What the equation of a ray and a round surface is made of: (way + t·d)² = r².
struct RoundSurface {
  glm::dvec3 way, d;
  double r;
};

/// Of a sphere, or of a cylinder's side in the plane in which it is the unit circle.
std::optional<RoundSurface> round_surface(const Case& one) {
  if (ray_question(one) == nullptr) return std::nullopt;
  const auto [o, d, t_min, t_max] = ray_in_object(*ray_question(one));
  if (const auto* sphere = shape_in<Sphere<double>>(one))
    return RoundSurface{o - sphere->center, d, sphere->radius};
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr) return std::nullopt;
  const glm::dvec3 scale(1 / cylinder->rx, 1 / cylinder->ry, 0);
  return RoundSurface{o * scale, d * scale, 1};
}

Answers of_round_surface(const Case& one, Product product, int axis) {
  const auto surface = round_surface(one);
  const auto equation = reduced_equation(one);
  if (!surface || !equation || (axis == 2 && shape_in<Cylinder<double>>(one) != nullptr)) return {};
  const auto& [way, d, r] = *surface;
  Answers answers;
  const bool has_way = product != Product::direction_squared,
             is_square = product != Product::way_and_direction;
  for (const double value : wrong_values(has_way ? way : d, is_square && has_way ? way : d, axis)) {
    ReducedEquation e = *equation;
    if (!has_way) e.a = value;
    if (!is_square) e.h = value;
    if (is_square && has_way) e.c = value - r * r;
    // One answer of each mistake: their places distinguish them.
    answers.push_back(with_roots(one, roots_by(-e.h, e.discriminant(), e.a)).front());
  }
  return answers;
}

Answers of_plane(const Case& one, Product product, int axis) {
  const auto plane = implicit_form(one);
  if (!plane) return {};
  const auto& [normal, d] = *plane;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec3 point = point_of_plane(one), way = ray.origin - point;
  const double constant = d + glm::dot(normal, point), height = glm::dot(normal, way) + constant;
  Answers answers;
  if (product == Product::normal_and_direction)
    for (const double slope : wrong_values(normal, ray.direction, axis))
      answers.push_back(hit_at(one, -height / slope, slope != 0).front());
  else
    for (const double value : wrong_values(normal, way, axis))
      answers.push_back(hit_at(one, -(value + constant) / glm::dot(normal, ray.direction), true).front());
  return answers;
}

}  // namespace

Answers with_wrong_term(const Case& one, Product product, int axis) {
  const bool is_of_plane = product == Product::normal_and_direction || product == Product::normal_and_origin;
  return is_of_plane ? of_plane(one, product, axis) : of_round_surface(one, product, axis);
}

}  // namespace rayproof::diagnosis
