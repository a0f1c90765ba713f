#include "properties/diagnosis/models/outlines/near_sides.hpp"

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

/// Where the point of a case is outside of its polygon, and not so near a side that rounding decides.
std::optional<PlaneHit> plainly_outside(const Case& one, const Answer& exact) {
  if (finds_something(exact) || shape_in<Triangle<double>>(one) != nullptr) return std::nullopt;
  auto seen = point_and_outline(one);
  if (seen && is_at_side(one.precision, seen->point, seen->vertices)) return std::nullopt;
  return seen;
}

/// A share of the diagonal of the polygon's bounds.
double share_of_size(const Outline& outline, double share) {
  const auto [low, high] = bounds_of(outline);
  return share * glm::length(high - low);
}

Answers found(const Case& one, const PlaneHit& seen) {
  if (ray_question(one) != nullptr) return hit_at(one, seen.t, true);
  return {Position::inside, Position::boundary};
}

}  // namespace

Answers near_sides_inside(const Case& one, const Answer& exact, double tolerance) {
  const auto seen = plainly_outside(one, exact);
  if (!seen) return {};
  const double near = share_of_size(seen->vertices, tolerance);
  return sides_within(near, seen->point, seen->vertices).empty() ? Answers{} : found(one, *seen);
}

Answers gap_is_inside(const Case& one, const Answer& exact, double tolerance) {
  const auto seen = plainly_outside(one, exact);
  if (!seen) return {};
  const std::size_t count = seen->vertices.size();
  const std::vector<std::size_t> near =
      sides_within(share_of_size(seen->vertices, tolerance), seen->point, seen->vertices);
  for (const std::size_t i : near)
    for (const std::size_t j : near)
      if (i != j && (i + 1) % count != j && (j + 1) % count != i) return found(one, *seen);
  return {};
}

Answers near_sides_boundary(const Case& one, const Answer& exact, double limit) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position == Position::boundary) return {};
  const auto seen = point_and_outline(one);
  const Outline& outline = seen->vertices;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (std::abs(turn(a, b, seen->point)) < limit && is_in_bounds(seen->point, {a, b}))
      return {Position::boundary};
  }
  return {};
}

Answers within_of_boundary(const Case& one, const Answer& exact, double limit) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position == Position::boundary) return {};
  const auto seen = point_and_outline(one);
  const bool is_near = !sides_within(limit, seen->point, seen->vertices).empty();
  return is_near ? Answers{Position::boundary} : Answers{};
}

}  // namespace rayproof::diagnosis
