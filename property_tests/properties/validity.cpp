#include "properties/validity.hpp"

#include <cmath>

#include "case/independent.hpp"
#include "properties/numbers.hpp"

namespace rayproof {

namespace {

bool is_valid_question(const Quadratic<double>& /*any finite numbers will do*/) { return true; }

bool is_valid_question(const PointAndPolygon<double>& asked) { return asked.vertices.size() >= 3; }

bool is_valid_question(const RayQuestion& asked) {
  if (asked.ray.direction == glm::dvec3(0) || !(asked.ray.t_min <= asked.ray.t_max)) return false;
  if (asked.transform && !is_regular(*asked.transform)) return false;
  try {
    std::visit([]<class S>(const S& shape) { ShapeFormat<S>::validate(shape); }, asked.shape);
  } catch (const Refusal&) {
    return false;
  }
  return true;
}

bool may_be(const CaseNumber& number) {
  if (std::isfinite(*number.value)) return true;
  if (number.field == "ray.t_min") return *number.value == -infinity<double>;
  return number.field == "ray.t_max" && *number.value == infinity<double>;
}

}  // namespace

bool is_valid(const Case& one) {
  Case copy = one;
  for (const CaseNumber& number : numbers_of(copy))
    if (!may_be(number)) return false;
  return std::visit([](const auto& asked) { return is_valid_question(asked); }, one.question);
}

}  // namespace rayproof
