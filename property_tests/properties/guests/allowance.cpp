#include "properties/guests/allowance.hpp"

#include <algorithm>
#include <vector>

#include "properties/trial.hpp"

namespace rayproof {
namespace {

/// The sum of the products that a Newell normal is made of, of vertices seen from a point.
double sum_of_products(const std::vector<glm::dvec3>& vertices, const glm::dvec3& from) {
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sum += glm::length(vertices[i] - from) * glm::length(vertices[(i + 1) % vertices.size()] - from);
  return sum;
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

double allowed_of_normal(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const bool has_map = asked != nullptr && asked->transform.has_value();
  return allowed_of_hits(one) * (has_map ? std::max(1.0, condition_of(*asked->transform)) : 1);
}

}  // namespace rayproof
