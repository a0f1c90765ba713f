#include "properties/diagnosis/models/outlines/inside_rules.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace rayproof::diagnosis {
namespace {

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

}  // namespace

bool is_inside(InsideRule rule, const glm::dvec2& point, const Outline& outline) {
  const std::size_t all = outline.size();
  const bool is_odd = crossings(point, outline, all, half_open) % 2 == 1;
  switch (rule) {
    case InsideRule::closed_sides:
      return crossings(point, outline, all, [](double a, double b) { return a * b <= 0; }) % 2 == 1;
    case InsideRule::closed_at_first:
      return crossings(point, outline, all, [](double a, double b) { return a * b < 0 || a == 0; }) % 2 == 1;
    case InsideRule::level_sides: {
      int more = 0;
      for (std::size_t i = 0; i < all; ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % all];
        more += a.y == point.y && b.y == point.y && std::max(a.x, b.x) > point.x ? 1 : 0;
      }
      return is_odd != (more % 2 == 1);
    }
    case InsideRule::not_level:
      return is_odd && std::ranges::none_of(outline, [&](const auto& v) { return v.y == point.y; });
    case InsideRule::exchanged:
      return crossings({point.y, point.x}, outline, all, half_open) % 2 == 1;
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
    case InsideRule::cut_off_turns: {
      int count = 0;
      for (std::size_t i = 0; i < all; ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % all];
        const double side = std::trunc(turn(a, b, point));
        count += half_open(a.y - point.y, b.y - point.y) && (b.y > a.y ? side > 0 : side < 0) ? 1 : 0;
      }
      return count % 2 == 1;
    }
    case InsideRule::bounds_of_three:
      return is_odd && is_in_bounds(point, {outline[0], outline[1], outline[2]});
    case InsideRule::bounds:
      return is_in_bounds(point, outline);
  }
  return false;
}

}  // namespace rayproof::diagnosis
