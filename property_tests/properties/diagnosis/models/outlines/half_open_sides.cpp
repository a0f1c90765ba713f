#include "properties/diagnosis/models/outlines/half_open_sides.hpp"

#include <algorithm>
#include <utility>

#include "properties/diagnosis/models/outlines/outline_geometry.hpp"

namespace rayproof::diagnosis {
namespace {

/// The point and the outline turned so that the end is that at the greatest x.
PlaneHit turned_to_right(PlaneHit seen, EndOfSide end) {
  const bool is_of_y = end == EndOfSide::upper || end == EndOfSide::lower;
  const bool is_least = end == EndOfSide::left || end == EndOfSide::lower;
  const auto turned = [&](glm::dvec2 v) {
    if (is_of_y) std::swap(v.x, v.y);
    return is_least ? glm::dvec2(-v.x, v.y) : v;
  };
  seen.point = turned(seen.point);
  for (glm::dvec2& vertex : seen.vertices) vertex = turned(vertex);
  return seen;
}

}  // namespace

Answers lost_at_end(const Case& one, const Answer& exact, EndOfSide end) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position != Position::boundary) return {};
  const PlaneHit seen = turned_to_right(*point_and_outline(one), end);
  const Outline& outline = seen.vertices;
  bool is_on_upright = false;
  for (const std::size_t side : sides_within(0, seen.point, outline)) {
    const glm::dvec2 &a = outline[side], &b = outline[(side + 1) % outline.size()];
    if (seen.point.x < std::max(a.x, b.x)) return {};
    is_on_upright = is_on_upright || a.x == b.x;
  }
  return is_on_upright ? Answers{exact, Position::outside, Position::inside}
                       : Answers{Position::outside, Position::inside};
}

Answers on_side_without_length(const Case& one, const Answer& exact) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  if (place == nullptr || std::get<Position>(exact) == Position::boundary) return {};
  const Outline outline = point_and_outline(one)->vertices;
  const bool has_one =
      std::ranges::adjacent_find(outline) != outline.end() || outline.front() == outline.back();
  return has_one ? Answers{Position::boundary} : Answers{};
}

}  // namespace rayproof::diagnosis
