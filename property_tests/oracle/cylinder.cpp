#include "oracle/cylinder.hpp"

#include "oracle/cylinder_equation.hpp"

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

}  // namespace

RayAnswer answer(const RayQuestion& question, const Cylinder<double>& cylinder, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const CylinderEquation equation(ray, cylinder);
  RayAnswer result;
  for (const CylinderHit& hit : equation.hits()) {
    const auto note = [&](const auto& t) {
      if (!is_in_interval(t, question.ray)) return;
      const bool is_first = result.hits.count == 0;
      result.hits.push_back(round_correctly(t, precision));
      if (!is_first) return;
      result.contact = contact_of(hit, equation);
      result.point = exact_point(question.ray, t, precision);
    };
    const bool was_empty = result.hits.count == 0;
    std::visit(note, hit.t);
    const bool is_first = was_empty && result.hits.count == 1;
    if (!is_first || hit.is_on_rim) continue;
    const bool is_flat = cylinder.height == 0;  // both caps are here, and neither is outward
    if (hit.is_on_side) {
      result.normal = side_normal(ray, equation, cylinder, std::get<ExactRoot>(hit.t), precision);
    } else if (!is_flat) {
      const Vector<Ring> axis{Ring(0.0), Ring(0.0), Ring(static_cast<double>(hit.cap))};
      result.normal = unit_vector(normal_to_world(ray, axis), precision);
    }
  }
  if (result.hits.count == 0) result.contact = miss_contact(equation);
  return result;
}

}  // namespace rayproof::oracle
