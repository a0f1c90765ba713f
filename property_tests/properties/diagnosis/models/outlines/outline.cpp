#include "properties/diagnosis/models/outlines/outline.hpp"

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/first_hit/surface_normals.hpp"

namespace rayproof::diagnosis {

bool is_inside_outline(const PlaneHit& hit) {
  return crossings(hit.point, hit.vertices, hit.vertices.size(), half_open) % 2 == 1;
}

Answers inside_by(const Case& one, const Answer& exact, InsideRule rule, Sweep sweep) {
  const auto* position = std::get_if<Position>(&exact);
  const bool is_on_boundary = position != nullptr && *position == Position::boundary;
  if (is_on_boundary || shape_in<Triangle<double>>(one) != nullptr) return {};
  const auto hit = point_and_outline(one);
  if (!hit || is_at_side(one.precision, hit->point, hit->vertices)) return {};
  const PlaneHit seen = swept(sweep, *hit);
  const bool in = rule(seen.point, seen.vertices);
  Answers all = place_at(one, *hit, in);
  // A vertex on the point's level may count as above it, unless the rule is another one upside down.
  const bool is_symmetric = rule != inside::unturned && rule != inside::exchanged;
  const PlaneHit mirrored = upside_down(seen);
  if (is_symmetric && rule(mirrored.point, mirrored.vertices) != in)
    for (const Answer& other : place_at(one, *hit, !in)) all.push_back(other);
  return all;
}

Answers exchanged_in_projection(const Case& one, const Answer& exact) {
  return ray_question(one) != nullptr ? inside_by<inside::exchanged>(one, exact) : Answers{};
}

bool is_on_third_side(const Case& one) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  const auto seen = place == nullptr ? std::nullopt : point_and_outline(one);
  return seen && sides_within(0, seen->point, seen->vertices).size() > 2;
}

Answers plane_of_corner(const Case& one, const Answer& /*exact*/) {
  const auto figure = figure_of_corner(one);
  if (!figure) return {};
  const auto hit = plane_hit(one, *figure);
  if (!hit) return {RayAnswer{}};
  const bool is_in = is_inside_outline(*hit);
  Answers answers = hit_at(one, hit->t, is_in);
  if (is_at_side(one.precision, hit->point, hit->vertices))  // rounding decides
    answers.push_back(hit_at(one, hit->t, !is_in).front());
  for (Answer& answer : answers)
    if (auto& found = std::get<RayAnswer>(answer); found.hits.count > 0)
      found.normal = glm::normalize(map_of_normals(*ray_question(one)) * figure->normal);
  return answers;
}

namespace {

/// The same where `counts(a, b, point)` is true of the ends of a side.
template <class Counts>
Answers endless_boundary_of(const Case& one, const Answer& exact, Counts&& counts) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position == Position::boundary) return {};
  const PlaneHit seen = *point_and_outline(one);
  const Outline& outline = seen.vertices;
  bool is_on_line = false, is_on_longer = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const bool is_on_this = counts(a, b, seen.point) && turn(a, b, seen.point) == 0;
    is_on_line = is_on_line || is_on_this;
    is_on_longer = is_on_longer || (is_on_this && a != b);
  }
  if (!is_on_line) return {};
  // Bounds may be asked first, and sides without length be left out.
  const bool is_sure = is_on_longer && is_in_bounds(seen.point, outline);
  return is_sure ? Answers{Position::boundary} : Answers{Position::boundary, exact};
}

}  // namespace

Answers endless_boundary(const Case& one, const Answer& exact) {
  return endless_boundary_of(one, exact,
                             [](const glm::dvec2&, const glm::dvec2&, const glm::dvec2&) { return true; });
}
Answers endless_upright_boundary(const Case& one, const Answer& exact) {
  return endless_boundary_of(one, exact, [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    return a.x == b.x && p.x == a.x;
  });
}

Answers lost_on_bounds(const Case& one, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position != Position::boundary) return {};
  const PlaneHit seen = *point_and_outline(one);
  const auto [low, high] = bounds_of(seen.vertices);
  const glm::dvec2& p = seen.point;
  const bool is_on_border = p.x == low.x || p.x == high.x || p.y == low.y || p.y == high.y;
  return is_on_border ? Answers{Position::outside} : Answers{};
}

Answers lost_at_greatest(const Case& one, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position != Position::boundary) return {};
  return boundary_places(one).test(static_cast<std::size_t>(BoundaryPlace::greatest))
             ? Answers{Position::outside}
             : Answers{};
}

Answers never_inside(const Case& /*one*/, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  return position != nullptr && *position == Position::inside ? Answers{Position::outside} : Answers{};
}

Answers inside_out(const Case& /*one*/, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position == Position::boundary) return {};
  return {*position == Position::inside ? Position::outside : Position::inside};
}

std::optional<bool> wrong_where_concave(const Case& one, const Answer& got, const Answer& exact) {
  const auto seen = point_and_outline(one);
  if (!seen) return std::nullopt;
  const Outline& outline = seen->vertices;
  bool left = false, right = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double turned =
        turn(outline[i], outline[(i + 1) % outline.size()], outline[(i + 2) % outline.size()]);
    left = left || turned > 0;
    right = right || turned < 0;
  }
  if (!left || !right) return std::nullopt;
  return !agree(one, got, exact, Aspect::hits);
}

}  // namespace rayproof::diagnosis
