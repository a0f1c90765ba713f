#include "properties/diagnosis/models/hits/contacts.hpp"

#include "properties/boundary.hpp"
#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

bool is_contact(const Answer& exact, Contact contact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  return answer != nullptr && answer->contact == contact;
}

/// Whether the normal of a plane is along an axis, so that nothing of it is rounded; of other shapes always.
bool has_normal_along_axis(const Case& one) {
  const auto is_along = [](const glm::dvec3& n) { return (n.x != 0) + (n.y != 0) + (n.z != 0) == 1; };
  if (const auto* plane = shape_in<ImplicitPlane>(one)) return is_along(plane->normal);
  if (const auto* plane = shape_in<PointNormalPlane>(one)) return is_along(plane->normal);
  return true;
}

Answers if_position(const Answer& exact, Position from, Position to) {
  const auto* position = std::get_if<Position>(&exact);
  return position != nullptr && *position == from ? Answers{to} : Answers{};
}

/// A miss for that reason; under a transform rounding may turn the ray out of the plane.
Answers misses_by(const Case& one, Contact reason, const Answer& exact) {
  RayAnswer miss;
  miss.contact = reason;
  return ray_question(one)->transform ? Answers{miss, exact} : Answers{miss};
}

}  // namespace

Answers misses_tangents_along_axes(const Case& one, const Answer& exact) {
  Answers missed = misses_at<Contact::tangent>(one, exact);
  const RayQuestion* asked = ray_question(one);
  if (missed.empty() || asked == nullptr) return {};
  if (!runs_along_axis(ray_in_object(*asked))) missed.insert(missed.begin(), exact);
  return missed;
}

Answers boundary_is_outside(const Case& /*one*/, const Answer& exact) {
  if (std::holds_alternative<Position>(exact))
    return if_position(exact, Position::boundary, Position::outside);
  const bool is_on_it = is_contact(exact, Contact::edge) || is_contact(exact, Contact::vertex);
  return is_on_it ? Answers{RayAnswer{}} : Answers{};
}

Answers boundary_is_inside(const Case& /*one*/, const Answer& exact) {
  return if_position(exact, Position::boundary, Position::inside);
}

std::optional<bool> in_surface_is_hit(const Case& one, const Answer& got, const Answer& exact) {
  if (!is_contact(exact, Contact::in_surface)) return std::nullopt;
  if (finds_something(got)) return true;
  // It may say so at t = 0 alone, and where a normal that is made a unit vector keeps n·d = 0.
  const bool may_miss = !in_interval(ray_question(one)->ray, 0.0) || !has_normal_along_axis(one);
  return may_miss ? std::nullopt : std::optional(false);
}

Answers called_by_weights(const Case& /*one*/, const Answer& exact, double limit) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->barycentric) return {};
  const glm::dvec3& w = *answer->barycentric;
  const int small = int{w.x < limit} + int{w.y < limit} + int{w.z < limit};
  RayAnswer other = *answer;
  other.contact = small > 1 ? Contact::vertex : small == 1 ? Contact::edge : Contact::crossing;
  return {other};
}

Answers in_surface_is_parallel(const Case& one, const Answer& exact) {
  return is_contact(exact, Contact::in_surface) ? misses_by(one, Contact::parallel, exact) : Answers{};
}

Answers reasons_exchanged(const Case& one, const Answer& exact) {
  if (is_contact(exact, Contact::in_surface)) return misses_by(one, Contact::parallel, exact);
  return is_contact(exact, Contact::parallel) ? misses_by(one, Contact::in_surface, exact) : Answers{};
}

Answers no_reason(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || answer->hits.count > 0 || answer->contact == Contact::none) return {};
  return {RayAnswer{}};
}

}  // namespace rayproof::diagnosis
