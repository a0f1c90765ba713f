#include "properties/diagnosis/models/flat/outline.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/flat/outline_geometry.hpp"
#include "properties/diagnosis/models/surface_normals.hpp"

namespace rayproof::diagnosis {
namespace {

bool is_inside_first(std::size_t count, const glm::dvec2& point, Outline outline) {
  outline.resize(std::min(count, outline.size()));
  return crossings(point, outline, outline.size(), half_open) % 2 == 1;
}

/// Even and odd crossings where x is compared with `x_of(side)`.
bool is_inside_by(const glm::dvec2& point, const Outline& outline,
                  double (*x_of)(const glm::dvec2& from, const glm::dvec2& to)) {
  int count = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    count += half_open(a.y - point.y, b.y - point.y) && point.x < x_of(a, b) ? 1 : 0;
  }
  return count % 2 == 1;
}

/// The sum of the angles at which the sides are seen from the point, each without its sign, in turns.
double turns_without_sign(const glm::dvec2& point, const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i] - point, b = outline[(i + 1) % outline.size()] - point;
    sum += std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
  }
  return sum / (2 * glm::pi<double>());
}
constexpr double small_turn = 1e-4;

bool is_inside(InsideRule rule, const glm::dvec2& point, const Outline& outline) {
  const std::size_t all = outline.size();
  const bool is_odd = crossings(point, outline, all, half_open) % 2 == 1;
  switch (rule) {
    case InsideRule::closed_sides:
      return crossings(point, outline, all, [](double a, double b) { return a * b <= 0; }) % 2 == 1;
    case InsideRule::not_level:
      return is_odd && std::ranges::none_of(outline, [&](const auto& v) { return v.y == point.y; });
    case InsideRule::winding:
      return windings(point, outline) != 0;
    case InsideRule::endless_sides:
      return crossings(point, outline, all, [](double from, double to) { return from / (from - to) >= 0; }) %
                 2 ==
             1;
    case InsideRule::both_ways: {
      int level = 0;
      for (std::size_t i = 0; i < all; ++i)
        if (half_open(outline[i].y - point.y, outline[(i + 1) % all].y - point.y)) ++level;
      return level % 4 == 2;
    }
    case InsideRule::last_side:
      return crossings(point, outline, all - 1, half_open) % 2 == 1;
    case InsideRule::first_triangle:
      return is_on_one_side(point, {outline[0], outline[1], outline[2]});
    case InsideRule::first_four:
      return is_inside_first(4, point, outline);
    case InsideRule::first_eight:
      return is_inside_first(8, point, outline);
    case InsideRule::upright_sides: {
      int more = 0;  // those to the left, which even and odd crossings don't count
      for (std::size_t i = 0; i < all; ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % all];
        more += a.x == b.x && a.x < point.x && half_open(a.y - point.y, b.y - point.y) ? 1 : 0;
      }
      return is_odd != (more % 2 == 1);
    }
    case InsideRule::unrepeated: {
      Outline kept;
      for (const glm::dvec2& vertex : outline)
        if (std::ranges::find(kept, vertex) == kept.end()) kept.push_back(vertex);
      return crossings(point, kept, kept.size(), half_open) % 2 == 1;
    }
    case InsideRule::unturned: {
      int count = 0;  // upward sides to the right, downward ones to the left
      for (std::size_t i = 0; i < all; ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % all];
        const double left = (point.x - a.x) * (b.y - a.y), right = (b.x - a.x) * (point.y - a.y);
        count += half_open(a.y - point.y, b.y - point.y) && left < right ? 1 : 0;
      }
      return count % 2 == 1;
    }
    case InsideRule::first_end:
      return is_inside_by(point, outline, [](const glm::dvec2& from, const glm::dvec2&) { return from.x; });
    case InsideRule::second_end:
      return is_inside_by(point, outline, [](const glm::dvec2&, const glm::dvec2& to) { return to.x; });
    case InsideRule::farther_end:
      return is_inside_by(point, outline, [](const glm::dvec2& from, const glm::dvec2& to) {
        return std::max(from.x, to.x);
      });
    case InsideRule::any_crossing:
      return crossings(point, outline, all, half_open) > 0;
    case InsideRule::upward:
      return crossings(point, outline, all,
                       [](double from, double to) { return half_open(from, to) && to > from; }) %
                 2 ==
             1;
    case InsideRule::one_side:
      return is_on_one_side(point, outline);
    case InsideRule::fan:
      for (std::size_t i = 1; i + 1 < all; ++i)
        if (is_on_one_side(point, {outline[0], outline[i], outline[i + 1]})) return true;
      return false;
    case InsideRule::angles:
      return std::abs(turns_without_sign(point, outline) - 1) < small_turn;
    case InsideRule::angles_or_more:
      return turns_without_sign(point, outline) > 1 - small_turn;
    case InsideRule::angles_rounded:
      return std::lround(turns_without_sign(point, outline)) % 2 == 1;
    case InsideRule::bounds_of_three:
      return is_odd && is_in_bounds(point, {outline[0], outline[1], outline[2]});
    case InsideRule::bounds_but_first:
      return is_odd && is_in_bounds(point, Outline(outline.begin() + 1, outline.end()));
    case InsideRule::bounds:
      return is_in_bounds(point, outline);
  }
  return false;
}

PlaneHit upside_down(PlaneHit seen) {
  seen.point.y = -seen.point.y;
  for (glm::dvec2& vertex : seen.vertices) vertex.y = -vertex.y;
  return seen;
}

}  // namespace

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
  const bool in = is_inside(rule, seen.point, seen.vertices);
  Answers all = place_at(one, *hit, in);
  // A vertex on the point's level may count as above it; of what is not turned round that is another rule.
  const PlaneHit mirrored = upside_down(seen);
  if (rule != InsideRule::unturned && is_inside(rule, mirrored.point, mirrored.vertices) != in)
    for (const Answer& other : place_at(one, *hit, !in)) all.push_back(other);
  return all;
}

bool is_on_third_side(const Case& one) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  const auto seen = place == nullptr ? std::nullopt : point_and_outline(one);
  return seen && sides_within(0, seen->point, seen->vertices) > 2;
}

Answers plane_of_corner(const Case& one, const Answer& /*exact*/) {
  const auto figure = figure_of_corner(one);
  if (!figure) return {};
  const auto hit = plane_hit(one, *figure);
  if (!hit) return {RayAnswer{}};
  if (is_at_side(one.precision, hit->point, hit->vertices)) return {};
  Answers answers = hit_at(one, hit->t, is_inside_outline(*hit));
  auto& found = std::get<RayAnswer>(answers.front());
  if (found.hits.count > 0)
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
  bool is_on_line = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    is_on_line = is_on_line || (counts(a, b, seen.point) && turn(a, b, seen.point) == 0);
  }
  if (!is_on_line) return {};
  return is_in_bounds(seen.point, outline) ? Answers{Position::boundary} : Answers{Position::boundary, exact};
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

Answers near_sides_inside(const Case& one, const Answer& exact, double tolerance) {
  if (finds_something(exact) || shape_in<Triangle<double>>(one) != nullptr) return {};
  const auto seen = point_and_outline(one);
  if (!seen || is_at_side(one.precision, seen->point, seen->vertices)) return {};
  const auto [low, high] = bounds_of(seen->vertices);
  const double near = tolerance * glm::length(high - low);
  if (sides_within(near, seen->point, seen->vertices) == 0) return {};
  if (ray_question(one) != nullptr) return hit_at(one, seen->t, true);
  return {Position::inside, Position::boundary};
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
