#include "properties/guests/allowance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "case/each_number.hpp"
#include "properties/trial.hpp"
#include "subjects/default_contract.hpp"

namespace rayproof {
namespace {

/// The sum of the products that a Newell normal is made of, of vertices seen from a point.
double sum_of_products(const std::vector<glm::dvec3>& vertices, const glm::dvec3& from) {
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sum += glm::length(vertices[i] - from) * glm::length(vertices[(i + 1) % vertices.size()] - from);
  return sum;
}

/// About how far the shape reaches from (0, 0, 0) of the world; 0 of a plane, which has no end.
double reach_in_world(const RayQuestion& asked) {
  double reach = 0;
  const auto note = [&]<class S>(const S& shape) {
    if (std::string_view(ShapeFormat<S>::type) == "plane") return;
    each_number(shape, [&](const double& x) { reach = std::max(reach, std::abs(x)); });
  };
  std::visit(note, asked.shape);
  if (!asked.transform) return reach;
  const glm::dmat4& map = *asked.transform;
  const double longest = std::sqrt(dot(map[0], map[0]) + dot(map[1], map[1]) + dot(map[2], map[2]));
  return reach * longest + glm::length(glm::dvec3(map[3]));
}

/// How many radii the centre of a sphere is from (0, 0, 0); 0 of other shapes.
double radii_away(const RayQuestion& asked) {
  const auto* sphere = std::get_if<Sphere<double>>(&asked.shape);
  return sphere == nullptr || sphere->radius == 0 ? 0 : glm::length(sphere->center) / sphere->radius;
}

}  // namespace

double allowed_of_hits(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const auto* polygon = asked == nullptr ? nullptr : std::get_if<Polygon<double>>(&asked->shape);
  if (polygon == nullptr) return 1;
  const double in_units = sum_of_products(polygon->vertices, glm::dvec3(0));
  const double plain = sum_of_products(polygon->vertices, polygon->vertices.front());
  return in_units > 0 ? std::max(1.0, plain / in_units) : 1;
}

double allowed_of_normal(const Case& one, double far, double residual) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const bool has_map = asked != nullptr && asked->transform.has_value();
  const double of_round = loses_digits_from_afar(topic_of(one))
                              ? std::max(1.0, far) * std::max(1.0, residual) + radii_away(*asked)
                              : 1;
  return allowed_of_hits(one) * of_round * (has_map ? std::max(1.0, condition_of(*asked->transform)) : 1);
}

double allowed_of_point(const Case& one, double t, double condition_of_coordinates) {
  const auto& asked = std::get<RayQuestion>(one.question);
  // What the oracle divides by, less what it adds for underflow, which 0 must not be divided by either.
  const double unit = glm::length(asked.ray.origin) + std::abs(t) * glm::length(asked.ray.direction) +
                      std::numeric_limits<double>::min();
  const double condition = asked.transform ? condition_of(*asked.transform) : 1;
  const double of_shape = std::max(1.0, condition_of_coordinates) * reach_in_world(asked);
  return std::max(1.0, condition) * (1 + of_shape / unit);
}

}  // namespace rayproof
