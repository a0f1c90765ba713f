#include "properties/shrink/shrink.hpp"

#include <algorithm>
#include <cmath>

#include "case/accepted.hpp"
#include "properties/numbers.hpp"
#include "properties/shrink/moves.hpp"

namespace rayproof {

namespace {

bool may_be(const CaseNumber& number) {
  if (std::isfinite(*number.value)) return true;
  if (number.field == "ray.t_min") return *number.value == -infinity<double>;
  return number.field == "ray.t_max" && *number.value == infinity<double>;
}

// Whether a figure is a proper one of its kind, whose vertices differ from their neighbours and enclose an
// area, and which is not flat.
bool is_proper(const std::vector<glm::dvec3>& vertices) {
  glm::dvec3 area(0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::dvec3& next = vertices[(i + 1) % vertices.size()];
    if (vertices[i] == next) return false;
    area += glm::cross(vertices[i], next);
  }
  return area != glm::dvec3(0);
}
bool is_proper(const std::vector<Vec2<double>>& vertices) {
  std::vector<glm::dvec3> in_space;
  for (const Vec2<double>& vertex : vertices) in_space.emplace_back(vertex.x, vertex.y, 0);
  return is_proper(in_space);
}
template <class Shape>
bool is_proper(const Shape& /*always so*/) {
  return true;
}
bool is_proper(const Polygon<double>& polygon) { return is_proper(polygon.vertices); }
bool is_proper(const Triangle<double>& t) { return are_independent(t.b - t.a, t.c - t.a); }
bool is_proper(const Cylinder<double>& cylinder) { return cylinder.height > 0; }
bool is_proper(const Box<double>& box) {
  return box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
}
bool is_proper(const PointAndPolygon<double>& place) { return is_proper(place.vertices); }
bool is_proper(const RayQuestion& asked) {
  return std::visit([](const auto& shape) { return is_proper(shape); }, asked.shape);
}
bool is_proper(const Case& one) {
  return std::visit([](const auto& asked) { return is_proper(asked); }, one.question);
}

/// What may take the place of a case: one below its complexity that is valid, and a proper figure for a
/// proper one.
struct Simpler {
  unsigned limit;
  bool stays_proper;

  explicit Simpler(const Case& than) : limit(complexity(than)), stays_proper(is_proper(than)) {}

  [[nodiscard]] bool admits(const Case& candidate) const {
    return complexity(candidate) < limit && is_valid(candidate) && (!stays_proper || is_proper(candidate));
  }
};

}  // namespace

Case shrink(const Case& start, const std::function<bool(const Case&)>& breaks, const ShrinkBudget& budget) {
  Case best = start;
  Simpler simpler(start);
  bool improved = true;
  unsigned tries_left = budget.tries;
  const auto end = std::chrono::steady_clock::now() + budget.time;
  const auto is_over = [&] {
    return tries_left == 0 || (budget.stop != nullptr && *budget.stop) ||
           (tries_left % 64 == 0 && std::chrono::steady_clock::now() > end);
  };
  const auto consider = [&](const Case& candidate) {
    if (!simpler.admits(candidate) || is_over()) return;
    --tries_left;
    if (!breaks(candidate)) return;
    best = candidate;
    simpler.limit = complexity(candidate);
    improved = true;
  };
  while (improved && !is_over()) {
    improved = false;
    make_moves(best, consider);
  }
  return best;
}

std::vector<Case> simpler_cases(const Case& one) {
  std::vector<Case> all;
  const Simpler simpler(one);
  make_moves(one, [&](const Case& candidate) {
    if (simpler.admits(candidate)) all.push_back(candidate);
  });
  return all;
}

bool is_valid(const Case& one) {
  Case copy = one;
  return std::ranges::all_of(numbers_of(copy), may_be) &&
         std::visit([](const auto& asked) { return is_accepted(asked); }, one.question);
}

std::function<bool(const Case&)> striking_break(const Subject& subject, const Property& property,
                                                Trial& as_found) {
  constexpr double striking = 100;
  const double wanted = property.excess != nullptr ? std::min(property.excess(as_found), striking) : 0;
  return [&subject, &property, wanted](const Case& candidate) {
    Trial trial(subject, candidate);
    return ruling_of(property, trial) == Ruling::broken &&
           (property.excess == nullptr || property.excess(trial) >= wanted);
  };
}

}  // namespace rayproof
