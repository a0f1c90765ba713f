#include "properties/diagnosis/models/outlines/wrong_crossing.hpp"

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/models/outlines/outline_geometry.hpp"

namespace rayproof::diagnosis {
namespace {

/// A side from a to b, and the point, whose y is the level.
struct SideAtLevel {
  glm::dvec2 a, b;
  double x, y;
  [[nodiscard]] double width() const { return b.x - a.x; }
  [[nodiscard]] double height() const { return b.y - a.y; }
};

/// The x that is taken for that of the crossing.
using CrossingX = double (*)(const SideAtLevel& s);

/// Mistakes in a.x + (y - a.y) (b.x - a.x) / (b.y - a.y), of either order of the vertices.
constexpr CrossingX mistakes_of_ends[] = {
    [](const SideAtLevel& s) { return (s.y - s.a.y) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.b.x + (s.y - s.a.y) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.a.x - (s.y - s.a.y) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.b.y) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * s.height() / s.width(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * s.width(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * s.width() / std::abs(s.height()); },
    // Another coordinate stands where one belongs, or + where - does.
    [](const SideAtLevel& s) { return s.a.y + (s.y - s.a.y) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.x - s.a.y) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.x) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * (s.b.y - s.a.x) / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * (s.b.x - s.a.y) / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * s.width() / (s.b.x - s.a.y); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * s.width() / (s.b.y - s.a.x); },
    [](const SideAtLevel& s) { return s.a.x + (s.y + s.a.y) * s.width() / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * (s.b.x + s.a.x) / s.height(); },
    [](const SideAtLevel& s) { return s.a.x + (s.y - s.a.y) * s.width() / (s.b.y + s.a.y); },
};
/// And those in which the order is nothing.
constexpr CrossingX mistakes_of_sides[] = {
    [](const SideAtLevel& s) { return std::min(s.a.x, s.b.x); },
    [](const SideAtLevel& s) { return (s.a.x + s.b.x) / 2; },
};

/// Whether the point lies inside by even and odd crossings at such x.
bool is_inside_by(CrossingX x_of, bool is_turned, const PlaneHit& seen) {
  const Outline& outline = seen.vertices;
  bool is_inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    SideAtLevel side{outline[i], outline[(i + 1) % outline.size()], seen.point.x, seen.point.y};
    if (is_turned) std::swap(side.a, side.b);
    if (half_open(side.a.y - side.y, side.b.y - side.y) && seen.point.x < x_of(side)) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace

Answers wrong_crossing(const Case& one, const Answer& exact, Sweep sweep) {
  const auto* position = std::get_if<Position>(&exact);
  if (position != nullptr && *position == Position::boundary) return {};
  const auto hit = shape_in<Triangle<double>>(one) == nullptr ? point_and_outline(one) : std::nullopt;
  if (!hit || is_at_side(one.precision, hit->point, hit->vertices)) return {};
  const PlaneHit seen = swept(sweep, *hit);
  const auto is_level = [&](const glm::dvec2& vertex) { return vertex.y == seen.point.y; };
  if (std::ranges::any_of(seen.vertices, is_level)) return {};
  Answers all;
  const auto add = [&](CrossingX x_of, bool is_turned) {
    all.push_back(place_at(one, *hit, is_inside_by(x_of, is_turned, seen)).front());
  };
  for (const CrossingX x_of : mistakes_of_ends)
    for (const bool is_turned : {false, true}) add(x_of, is_turned);
  for (const CrossingX x_of : mistakes_of_sides) add(x_of, false);
  return all;
}

}  // namespace rayproof::diagnosis
