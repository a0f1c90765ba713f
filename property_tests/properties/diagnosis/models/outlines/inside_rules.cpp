#include "properties/diagnosis/models/outlines/inside_rules.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace rayproof::diagnosis {
namespace {

using Point = glm::dvec2;

/// How many sides there are, from a to b, of which that is so.
template <class Rule>
int sides_where(const Outline& outline, Rule&& is_so) {
  int count = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    count += is_so(outline[i], outline[(i + 1) % outline.size()]) ? 1 : 0;
  return count;
}

/// Whether the side has the point's level between its ends.
bool is_level(const Point& point, const Point& a, const Point& b) {
  return half_open(a.y - point.y, b.y - point.y);
}

/// Whether an odd number of sides is crossed, of those that `counts` by the heights of their ends.
template <class Counts>
bool is_odd_by(const Point& point, const Outline& outline, const Counts& counts) {
  return crossings(point, outline, outline.size(), counts) % 2 == 1;
}
bool is_odd(const Point& point, const Outline& outline) { return is_odd_by(point, outline, half_open); }

/// The same where the point's x is compared with `x_of(side)`.
bool is_odd_before(const Point& point, const Outline& outline,
                   double (*x_of)(const Point& a, const Point& b)) {
  return sides_where(outline, [&](const Point& a,
                                  const Point& b) { return is_level(point, a, b) && point.x < x_of(a, b); }) %
             2 ==
         1;
}

/// The sum of the angles at which the sides are seen from the point, each without its sign, in turns.
double turns_without_sign(const Point& point, const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i] - point, b = outline[(i + 1) % outline.size()] - point;
    sum += std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
  }
  return sum / (2 * glm::pi<double>());
}
constexpr double small_turn = 1e-4;

}  // namespace

namespace inside {

bool closed_sides(const Point& point, const Outline& outline) {
  return is_odd_by(point, outline, [](double a, double b) { return a * b <= 0; });
}

bool closed_at_first(const Point& point, const Outline& outline) {
  return is_odd_by(point, outline, [](double a, double b) { return a * b < 0 || a == 0; });
}

bool level_sides(const Point& point, const Outline& outline) {
  const int more = sides_where(outline, [&](const Point& a, const Point& b) {
    return a.y == point.y && b.y == point.y && std::max(a.x, b.x) > point.x;
  });
  return is_odd(point, outline) != (more % 2 == 1);
}

bool not_level(const Point& point, const Outline& outline) {
  return is_odd(point, outline) &&
         std::ranges::none_of(outline, [&](const Point& v) { return v.y == point.y; });
}

bool exchanged(const Point& point, const Outline& outline) { return is_odd({point.y, point.x}, outline); }

bool winding(const Point& point, const Outline& outline) { return windings(point, outline) != 0; }

bool endless_sides(const Point& point, const Outline& outline) {
  return is_odd_by(point, outline, [](double from, double to) { return from / (from - to) >= 0; });
}

bool both_ways(const Point& point, const Outline& outline) {
  return sides_where(outline, [&](const Point& a, const Point& b) { return is_level(point, a, b); }) % 4 == 2;
}

bool last_side(const Point& point, const Outline& outline) {
  return crossings(point, outline, outline.size() - 1, half_open) % 2 == 1;
}

bool first_triangle(const Point& point, const Outline& outline) {
  return is_on_one_side(point, {outline[0], outline[1], outline[2]});
}

/// Those to the left are the ones that even and odd crossings do not count.
bool upright_sides(const Point& point, const Outline& outline) {
  const int more = sides_where(outline, [&](const Point& a, const Point& b) {
    return a.x == b.x && a.x < point.x && is_level(point, a, b);
  });
  return is_odd(point, outline) != (more % 2 == 1);
}

bool unrepeated(const Point& point, const Outline& outline) {
  Outline kept;
  for (const Point& vertex : outline)
    if (std::ranges::find(kept, vertex) == kept.end()) kept.push_back(vertex);
  return is_odd(point, kept);
}

/// Upward sides to the right count, and downward ones to the left.
bool unturned(const Point& point, const Outline& outline) {
  return sides_where(outline,
                     [&](const Point& a, const Point& b) {
                       const double left = (point.x - a.x) * (b.y - a.y),
                                    right = (b.x - a.x) * (point.y - a.y);
                       return is_level(point, a, b) && left < right;
                     }) %
             2 ==
         1;
}

bool first_end(const Point& point, const Outline& outline) {
  return is_odd_before(point, outline, [](const Point& a, const Point&) { return a.x; });
}

bool second_end(const Point& point, const Outline& outline) {
  return is_odd_before(point, outline, [](const Point&, const Point& b) { return b.x; });
}

bool farther_end(const Point& point, const Outline& outline) {
  return is_odd_before(point, outline, [](const Point& a, const Point& b) { return std::max(a.x, b.x); });
}

bool any_crossing(const Point& point, const Outline& outline) {
  return crossings(point, outline, outline.size(), half_open) > 0;
}

bool upward(const Point& point, const Outline& outline) {
  return is_odd_by(point, outline, [](double from, double to) { return half_open(from, to) && to > from; });
}

bool one_side(const Point& point, const Outline& outline) { return is_on_one_side(point, outline); }

bool fan(const Point& point, const Outline& outline) {
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    if (is_on_one_side(point, {outline[0], outline[i], outline[i + 1]})) return true;
  return false;
}

bool angles(const Point& point, const Outline& outline) {
  return std::abs(turns_without_sign(point, outline) - 1) < small_turn;
}

bool angles_or_more(const Point& point, const Outline& outline) {
  return turns_without_sign(point, outline) > 1 - small_turn;
}

bool angles_rounded(const Point& point, const Outline& outline) {
  return std::lround(turns_without_sign(point, outline)) % 2 == 1;
}

bool cut_off_turns(const Point& point, const Outline& outline) {
  return sides_where(outline,
                     [&](const Point& a, const Point& b) {
                       const double side = std::trunc(turn(a, b, point));
                       return is_level(point, a, b) && (b.y > a.y ? side > 0 : side < 0);
                     }) %
             2 ==
         1;
}

bool bounds_of_three(const Point& point, const Outline& outline) {
  return is_odd(point, outline) && is_in_bounds(point, {outline[0], outline[1], outline[2]});
}

bool bounds(const Point& point, const Outline& outline) { return is_in_bounds(point, outline); }

}  // namespace inside

}  // namespace rayproof::diagnosis
