#include "properties/diagnosis/models/outlines/outline_geometry.hpp"

#include <algorithm>

namespace rayproof::diagnosis {
namespace {

double distance_to_side(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 side = b - a, way = point - a;
  const double length = glm::dot(side, side);
  const double along = length > 0 ? std::clamp(glm::dot(way, side) / length, 0.0, 1.0) : 0.0;
  return glm::length(way - along * side);
}

}  // namespace

std::optional<PlaneHit> point_and_outline(const Case& one) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  if (place == nullptr) return plane_hit(one);
  PlaneHit seen{0, {place->point.x, place->point.y}, {}, 2};
  for (const auto& vertex : place->vertices) seen.vertices.emplace_back(vertex.x, vertex.y);
  return seen;
}

int windings(const glm::dvec2& point, const Outline& outline) {
  const auto passes = [&](bool is_upward) {
    return crossings(point, outline, outline.size(), [is_upward](double from, double to) {
      return is_upward ? from <= 0 && to > 0 : from > 0 && to <= 0;
    });
  };
  return passes(true) - passes(false);
}

std::pair<glm::dvec2, glm::dvec2> bounds_of(const Outline& outline) {
  glm::dvec2 low = outline.front(), high = low;
  for (const glm::dvec2& vertex : outline) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  return {low, high};
}

bool is_in_bounds(const glm::dvec2& point, const Outline& outline) {
  const auto [low, high] = bounds_of(outline);
  return low.x <= point.x && point.x <= high.x && low.y <= point.y && point.y <= high.y;
}

bool is_on_one_side(const glm::dvec2& point, const Outline& outline) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double turned = turn(outline[i], outline[(i + 1) % outline.size()], point);
    left = left || turned > 0;
    right = right || turned < 0;
  }
  return !(left && right);
}

std::vector<std::size_t> sides_within(double distance, const glm::dvec2& point, const Outline& outline) {
  std::vector<std::size_t> sides;
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (distance_to_side(point, outline[i], outline[(i + 1) % outline.size()]) <= distance)
      sides.push_back(i);
  return sides;
}

bool is_at_side(Precision precision, const glm::dvec2& point, const Outline& outline) {
  double size = glm::length(point);
  for (const glm::dvec2& vertex : outline) size = std::max(size, glm::length(vertex));
  return !sides_within(size * (precision == Precision::float32 ? 0x1p-18 : 0x1p-44), point, outline).empty();
}

}  // namespace rayproof::diagnosis
