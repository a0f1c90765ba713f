#include "properties/diagnosis/models/outlines/left_out.hpp"

#include <algorithm>

#include "properties/diagnosis/models/outlines/outline.hpp"

namespace rayproof::diagnosis {
namespace {

/// The point and outline of a polygon's case that is not on the boundary, nor so near that rounding decides.
std::optional<PlaneHit> off_sides(const Case& one, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  const bool is_on_boundary = position != nullptr && *position == Position::boundary;
  if (is_on_boundary || shape_in<Triangle<double>>(one) != nullptr) return std::nullopt;
  auto hit = point_and_outline(one);
  if (hit && is_at_side(one.precision, hit->point, hit->vertices)) return std::nullopt;
  return hit;
}

/// Whether the point is inside by even and odd crossings of all sides but that from one vertex.
bool is_inside_without(std::size_t side, const PlaneHit& seen) {
  const Outline& all = seen.vertices;
  Outline pair{all[side], all[(side + 1) % all.size()]};
  const int missing = crossings(seen.point, pair, 1, half_open);
  return (crossings(seen.point, all, all.size(), half_open) - missing) % 2 == 1;
}

}  // namespace

Answers inside_of_first(const Case& one, const Answer& exact, std::size_t count) {
  const auto hit = off_sides(one, exact);
  if (!hit) return {};
  PlaneHit first = *hit;
  first.vertices.resize(std::min(count, first.vertices.size()));
  const bool is_in = is_inside_outline(first);
  Answers all = place_at(one, *hit, is_in);
  // A vertex on the point's level may count as above it.
  if (is_inside_outline(upside_down(first)) != is_in) all.push_back(place_at(one, *hit, !is_in).front());
  return all;
}

Answers without_side(const Case& one, const Answer& exact, int from) {
  const auto hit = off_sides(one, exact);
  if (!hit) return {};
  const auto side = static_cast<std::size_t>(from < 0 ? from + std::ssize(hit->vertices) : from);
  Answers all;
  for (const Sweep sweep : {Sweep::along, Sweep::against, Sweep::along_in_order, Sweep::against_in_order,
                            Sweep::upward, Sweep::downward}) {
    const PlaneHit seen = swept(sweep, *hit);
    for (const PlaneHit& turned : {seen, upside_down(seen)})
      all.push_back(place_at(one, *hit, is_inside_without(side, turned)).front());
  }
  return all;
}

}  // namespace rayproof::diagnosis
