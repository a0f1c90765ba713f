#include "oracle/geometry/intersection.hpp"

#include "oracle/geometry/sizes.hpp"

namespace rayproof::oracle {
namespace {

/// The normal at t as the world has it: by the inverse transpose, of unit length, each component within one
/// ulp of 1.
template <class Number>
glm::dvec3 unit_normal(const ObjectRay<Ring>& ray, ExactNormal& normal, const Number& t,
                       Precision precision) {
  Vector<Ring>& offset = normal.offset;
  std::optional<Vector<Ring>>& slope = normal.slope;
  if (ray.map) offset = ray.map->apply_transposed(offset);
  if (ray.map && slope) slope = ray.map->apply_transposed(*slope);
  const auto at = [&](int axis) {
    return slope ? t.affine_image(offset[axis], (*slope)[axis]).estimate() : approximate(offset[axis]);
  };
  const Vector<Scaled> n{at(0), at(1), at(2)};
  const Scaled length = norm(n);
  glm::dvec3 unit{};
  for (int axis = 0; axis < 3; ++axis) {
    if (n[axis].sign() == 0) continue;  // 0, and never -0
    const long double component = (n[axis] / length).value();
    unit[axis] = precision == Precision::float32 ? static_cast<double>(static_cast<float>(component))
                                                 : static_cast<double>(component);
  }
  return unit;
}

}  // namespace

RayAnswer answer(const ExactIntersection& exact, Precision precision) {
  const ExactContacts hits = exact.hits();
  RayAnswer answer{hits.empty() ? exact.miss() : hits.front().contact};
  if (hits.empty()) return answer;
  const auto rounded = [&](const auto& number) { return round_correctly(number, precision); };
  for (const ExactContact& hit : hits) answer.hits.push_back(std::visit(rounded, hit.t));
  const auto describe = [&](const auto& t) {
    const Ray<double>& ray = exact.question().ray;
    glm::dvec3& point = answer.point.emplace();
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = rounded(t.affine_image(Ring(ray.origin[axis]), Ring(ray.direction[axis])));
    if (auto normal = exact.normal(hits.front()))
      answer.normal = unit_normal(exact.ray(), *normal, t, precision);
  };
  std::visit(describe, hits.front().t);
  if (const auto weights = exact.barycentric()) {
    glm::dvec3& barycentric = answer.barycentric.emplace();
    for (int i = 0; i < 3; ++i) barycentric[i] = rounded(weights->at(static_cast<std::size_t>(i)));
  }
  return answer;
}

}  // namespace rayproof::oracle
