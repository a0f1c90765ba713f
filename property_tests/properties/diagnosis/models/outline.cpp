#include "properties/diagnosis/models/outline.hpp"

#include <algorithm>
#include <glm/vec2.hpp>

#include "properties/diagnosis/agreement.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

using Outline = std::vector<glm::dvec2>;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How often a ray from the point along x crosses sides; `counts(from, to)` of the heights of a side's ends
/// over the point decides whether a side is crossed at all.
template <class Counts>
int crossings(const glm::dvec2& point, const Outline& outline, std::size_t sides, Counts&& counts) {
  int sum = 0;
  for (std::size_t i = 0; i < sides; ++i) {
    const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if (a.y == b.y || !counts(a.y - point.y, b.y - point.y)) continue;
    if (a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) >= point.x) ++sum;
  }
  return sum;
}

bool half_open(double from, double to) { return (from <= 0) != (to <= 0); }

int windings(const glm::dvec2& point, const Outline& outline) {
  const auto passes = [&](bool is_upward) {
    return crossings(point, outline, outline.size(), [is_upward](double from, double to) {
      return is_upward ? from <= 0 && to > 0 : from > 0 && to <= 0;
    });
  };
  return passes(true) - passes(false);
}

bool is_in_bounds(const glm::dvec2& point, const Outline& outline) {
  glm::dvec2 low = outline.front(), high = low;
  for (const glm::dvec2& vertex : outline) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  return low.x <= point.x && point.x <= high.x && low.y <= point.y && point.y <= high.y;
}

/// Whether all sides turn one way round the point.
bool is_on_one_side(const glm::dvec2& point, const Outline& outline) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double turned = turn(outline[i], outline[(i + 1) % outline.size()], point);
    left = left || turned > 0;
    right = right || turned < 0;
  }
  return !(left && right);
}

double distance_to_side(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 side = b - a, way = point - a;
  const double length = glm::dot(side, side);
  const double along = length > 0 ? std::clamp(glm::dot(way, side) / length, 0.0, 1.0) : 0.0;
  return glm::length(way - along * side);
}

/// Whether the point is so near a side that rounding decides.
bool is_at_side(Precision precision, const glm::dvec2& point, const Outline& outline) {
  double size = glm::length(point);
  for (const glm::dvec2& vertex : outline) size = std::max(size, glm::length(vertex));
  const double near = size * (precision == Precision::float32 ? 0x1p-18 : 0x1p-44);
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (distance_to_side(point, outline[i], outline[(i + 1) % outline.size()]) <= near) return true;
  return false;
}

bool is_inside_first(std::size_t count, const glm::dvec2& point, Outline outline) {
  outline.resize(std::min(count, outline.size()));
  return crossings(point, outline, outline.size(), half_open) % 2 == 1;
}

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
    case InsideRule::one_side:
      return is_on_one_side(point, outline);
    case InsideRule::fan:
      for (std::size_t i = 1; i + 1 < all; ++i)
        if (is_on_one_side(point, {outline[0], outline[i], outline[i + 1]})) return true;
      return false;
    case InsideRule::bounds:
      return is_in_bounds(point, outline);
  }
  return false;
}

Outline outline_of(const PointAndPolygon<double>& place) {
  Outline outline;
  for (const auto& vertex : place.vertices) outline.emplace_back(vertex.x, vertex.y);
  return outline;
}

/// The point and the outline turned so that the sweep goes along x.
PlaneHit swept(Sweep sweep, PlaneHit hit) {
  const bool is_in_order = sweep == Sweep::along_in_order || sweep == Sweep::against_in_order;
  const bool is_across = sweep == Sweep::upward || sweep == Sweep::downward;
  const bool is_against =
      sweep == Sweep::against || sweep == Sweep::against_in_order || sweep == Sweep::downward;
  const auto turned = [&](glm::dvec2 v) {
    if (is_across || (is_in_order && hit.axis == 1)) std::swap(v.x, v.y);
    return glm::dvec2(is_against ? -v.x : v.x, v.y);
  };
  hit.point = turned(hit.point);
  for (glm::dvec2& vertex : hit.vertices) vertex = turned(vertex);
  return hit;
}

Outline outline_of(const Case& one) {
  if (const auto* place = std::get_if<PointAndPolygon<double>>(&one.question)) return outline_of(*place);
  const auto hit = plane_hit(one);
  return hit ? hit->vertices : Outline{};
}

}  // namespace

bool is_inside_outline(const PlaneHit& hit) {
  return crossings(hit.point, hit.vertices, hit.vertices.size(), half_open) % 2 == 1;
}

template <InsideRule rule, Sweep sweep>
Answers inside_by(const Case& one, const Answer& exact) {
  if (const auto* place = std::get_if<PointAndPolygon<double>>(&one.question)) {
    if (std::get<Position>(exact) == Position::boundary) return {};
    const PlaneHit seen = swept(sweep, {0, {place->point.x, place->point.y}, outline_of(*place), 2});
    if (is_at_side(one.precision, seen.point, seen.vertices)) return {};
    const bool in = is_inside(rule, seen.point, seen.vertices);
    return {in ? Position::inside : Position::outside};
  }
  if (shape_in<Polygon<double>>(one) == nullptr) return {};
  const auto hit = plane_hit(one);
  if (!hit || is_at_side(one.precision, hit->point, hit->vertices)) return {};
  const PlaneHit seen = swept(sweep, *hit);
  return hit_at(one, hit->t, is_inside(rule, seen.point, seen.vertices));
}

template Answers inside_by<InsideRule::closed_sides>(const Case&, const Answer&);
template Answers inside_by<InsideRule::not_level>(const Case&, const Answer&);
template Answers inside_by<InsideRule::winding>(const Case&, const Answer&);
template Answers inside_by<InsideRule::endless_sides>(const Case&, const Answer&);
template Answers inside_by<InsideRule::both_ways>(const Case&, const Answer&);
template Answers inside_by<InsideRule::last_side>(const Case&, const Answer&);
template Answers inside_by<InsideRule::last_side, Sweep::against>(const Case&, const Answer&);
template Answers inside_by<InsideRule::last_side, Sweep::along_in_order>(const Case&, const Answer&);
template Answers inside_by<InsideRule::last_side, Sweep::against_in_order>(const Case&, const Answer&);
template Answers inside_by<InsideRule::last_side, Sweep::upward>(const Case&, const Answer&);
template Answers inside_by<InsideRule::last_side, Sweep::downward>(const Case&, const Answer&);
template Answers inside_by<InsideRule::first_triangle>(const Case&, const Answer&);
template Answers inside_by<InsideRule::first_four>(const Case&, const Answer&);
template Answers inside_by<InsideRule::first_eight>(const Case&, const Answer&);
template Answers inside_by<InsideRule::upright_sides>(const Case&, const Answer&);
template Answers inside_by<InsideRule::unrepeated>(const Case&, const Answer&);
template Answers inside_by<InsideRule::unturned>(const Case&, const Answer&);
template Answers inside_by<InsideRule::one_side>(const Case&, const Answer&);
template Answers inside_by<InsideRule::fan>(const Case&, const Answer&);
template Answers inside_by<InsideRule::bounds>(const Case&, const Answer&);

bool is_on_third_side(const Case& one) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  if (place == nullptr) return false;
  const glm::dvec2 point(place->point.x, place->point.y);
  const Outline outline = outline_of(*place);
  int sides = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    sides += distance_to_side(point, outline[i], outline[(i + 1) % outline.size()]) == 0 ? 1 : 0;
  return sides > 2;
}

Answers plane_of_corner(const Case& one, const Answer& /*exact*/) {
  auto figure = flat_figure(one);
  if (!figure || shape_in<Polygon<double>>(one) == nullptr) return {};
  figure->normal = normal_of_corner(figure->vertices);
  const auto hit = plane_hit(one, *figure);
  if (!hit) return {RayAnswer{}};
  if (is_at_side(one.precision, hit->point, hit->vertices)) return {};
  return hit_at(one, hit->t, is_inside_outline(*hit));
}

Answers endless_boundary(const Case& one, const Answer& exact) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  if (place == nullptr || std::get<Position>(exact) == Position::boundary) return {};
  const glm::dvec2 point(place->point.x, place->point.y);
  const Outline outline = outline_of(*place);
  bool is_on_line = false;
  for (std::size_t i = 0; i < outline.size(); ++i)
    is_on_line = is_on_line || turn(outline[i], outline[(i + 1) % outline.size()], point) == 0;
  if (!is_on_line) return {};
  return is_in_bounds(point, outline) ? Answers{Position::boundary} : Answers{Position::boundary, exact};
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
  const Outline outline = outline_of(one);
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
