#include "oracle/geometry/intersection.hpp"

#include "oracle/numbers/rounding.hpp"

namespace rayproof::oracle {
namespace {

/// Each component within one ulp of 1.
glm::dvec3 unit_vector(const std::array<Scaled, 3>& n, Precision precision) {
  const Scaled length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  glm::dvec3 unit{};
  for (int axis = 0; axis < 3; ++axis) {
    const long double component = (n[static_cast<std::size_t>(axis)] / length).value();
    unit[axis] = precision == Precision::float32 ? static_cast<double>(static_cast<float>(component))
                                                 : static_cast<double>(component);
  }
  return unit;
}

/// The normal at t as the world has it: by the inverse transpose, of unit length.
template <class Number>
glm::dvec3 unit_normal(const ObjectRay<Ring>& ray, ExactNormal& normal, const Number& t,
                       Precision precision) {
  auto& [offset, slope] = normal;
  if (ray.map) offset = ray.map->apply_transposed(offset);
  if (!slope)
    return unit_vector({approximate(offset.x), approximate(offset.y), approximate(offset.z)}, precision);
  if (ray.map) slope = ray.map->apply_transposed(*slope);
  const auto at = [&](const Ring& o, const Ring& s) { return t.affine_image(o, s).estimate(); };
  return unit_vector({at(offset.x, slope->x), at(offset.y, slope->y), at(offset.z, slope->z)}, precision);
}

}  // namespace

RayAnswer answer(const ExactIntersection& exact, Precision precision) {
  const std::vector<ExactContact> hits = exact.hits();
  RayAnswer answer;
  if (hits.empty()) {
    answer.contact = exact.miss();
    return answer;
  }
  for (const ExactContact& hit : hits) {
    const auto rounded = [&](const auto& t) { return round_correctly(t, precision); };
    answer.hits.push_back(std::visit(rounded, hit.t));
  }
  answer.contact = hits.front().contact;
  const auto describe = [&](const auto& t) {
    const Ray<double>& ray = exact.question().ray;
    glm::dvec3& point = answer.point.emplace();
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] =
          round_correctly(t.affine_image(Ring(ray.origin[axis]), Ring(ray.direction[axis])), precision);
    }
    if (auto normal = exact.normal(hits.front()))
      answer.normal = unit_normal(exact.ray(), *normal, t, precision);
  };
  std::visit(describe, hits.front().t);
  if (const auto weights = exact.barycentric()) {
    glm::dvec3& barycentric = answer.barycentric.emplace();
    for (int i = 0; i < 3; ++i)
      barycentric[i] = round_correctly(weights->at(static_cast<std::size_t>(i)), precision);
  }
  return answer;
}

}  // namespace rayproof::oracle
