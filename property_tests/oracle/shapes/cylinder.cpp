#include "oracle/shapes/cylinder.hpp"

#include "oracle/geometry/cylinder_equation.hpp"

namespace rayproof::oracle {
namespace {

/// A miss: whether the line runs inside an open cylinder's side.
Contact miss_contact(const CylinderEquation& equation) {
  const bool is_inside_side = !equation.capped && sign(equation.height) != 0 && equation.is_axis_parallel() &&
                              sign(equation.side().c) == 0;
  return is_inside_side ? Contact::in_surface : Contact::none;
}

/// The side's outward normal is the gradient (ry²·x, rx²·y, 0) of its equation.
glm::dvec3 side_normal(const ObjectRay<Ring>& ray, const CylinderEquation& equation,
                       const Cylinder<double>& cylinder, const ExactRoot& t, Precision precision) {
  const auto gradient = [&](const Vector<Ring>& v) {
    return normal_to_world(ray, {v.x * Ring(cylinder.ry), v.y * Ring(cylinder.rx), Ring(0.0)});
  };
  return unit_vector(gradient(equation.origin), gradient(equation.direction), t, precision);
}

Contact contact_of(const CylinderHit& hit, const CylinderEquation& equation) {
  if (hit.is_on_rim) return Contact::rim;
  const bool is_double = hit.is_on_side && sign(equation.side().discriminant()) == 0;
  return is_double ? Contact::tangent : Contact::crossing;
}

/// None on a rim, and none of a cylinder of no height: both its caps are in one plane, and neither is
/// outward.
std::optional<glm::dvec3> normal_of(const CylinderHit& hit, const ObjectRay<Ring>& ray,
                                    const CylinderEquation& equation, const Cylinder<double>& cylinder,
                                    Precision precision) {
  if (hit.is_on_rim) return std::nullopt;
  if (hit.is_on_side) return side_normal(ray, equation, cylinder, std::get<ExactRoot>(hit.t), precision);
  if (cylinder.height == 0) return std::nullopt;
  const Vector<Ring> axis{Ring(0.0), Ring(0.0), Ring(static_cast<double>(hit.cap))};
  return unit_vector(normal_to_world(ray, axis), precision);
}

}  // namespace

RayAnswer answer(const RayQuestion& question, const Cylinder<double>& cylinder, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const CylinderEquation equation(ray, cylinder);
  const std::vector<CylinderHit> on_line = equation.hits();
  const CylinderHit* first = nullptr;
  RayAnswer result;
  for (const CylinderHit& hit : on_line) {
    const auto counts = [&](const auto& t) { return is_in_interval(t, question.ray); };
    if (!std::visit(counts, hit.t)) continue;
    if (first == nullptr) first = &hit;
    result.hits.push_back(std::visit([&](const auto& t) { return round_correctly(t, precision); }, hit.t));
  }
  if (first == nullptr) {
    result.contact = miss_contact(equation);
    return result;
  }
  result.contact = contact_of(*first, equation);
  result.point = std::visit([&](const auto& t) { return exact_point(question.ray, t, precision); }, first->t);
  result.normal = normal_of(*first, ray, equation, cylinder, precision);
  return result;
}

}  // namespace rayproof::oracle
