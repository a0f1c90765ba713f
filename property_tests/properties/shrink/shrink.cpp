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

/// The way from a case down to the simplest that still breaks.
class Descent {
 public:
  Descent(const Case& start, const Breaking& breaking, const ShrinkBudget& budget)
      : breaking_(breaking), budget_(budget), best_(start), simpler_(start), tries_left_(budget.tries) {}

  Case lowest() {
    for (bool improved = true; improved && !is_over();) {
      improved_ = false;
      for (const Move move : moves()) {
        move(best_, [this](const Case& candidate) { consider(candidate); });
        ask();  // before the next move, which may count on what the last has left out
      }
      improved = improved_;
    }
    return best_;
  }

 private:
  [[nodiscard]] bool is_over() const {
    return tries_left_ == 0 || (budget_.stop != nullptr && *budget_.stop) ||
           (tries_left_ % 64 == 0 && std::chrono::steady_clock::now() > end_);
  }

  void consider(const Case& candidate) {
    if (!simpler_.admits(candidate) || is_over()) return;
    --tries_left_;
    waiting_.push_back(candidate);
    if (waiting_.size() >= breaking_.at_once) ask();
  }

  /// What waits behind the first that breaks was made of a case that is best no longer: the next round makes
  /// it anew.
  void ask() {
    const auto first = waiting_.empty() ? std::nullopt : breaking_.first(waiting_);
    if (first) {
      best_ = waiting_.at(*first);
      simpler_.limit = complexity(best_);
      improved_ = true;
    }
    waiting_.clear();
  }

  const Breaking& breaking_;
  const ShrinkBudget& budget_;
  Case best_;
  Simpler simpler_;
  bool improved_ = false;
  unsigned tries_left_;
  std::vector<Case> waiting_{};
  std::chrono::steady_clock::time_point end_ = std::chrono::steady_clock::now() + budget_.time;
};

}  // namespace

Case shrink(const Case& start, const Breaking& breaking, const ShrinkBudget& budget) {
  return Descent(start, breaking, budget).lowest();
}

Case shrink(const Case& start, const std::function<bool(const Case&)>& breaks, const ShrinkBudget& budget) {
  const auto first = [&](std::span<const Case> cases) -> std::optional<std::size_t> {
    return breaks(cases.front()) ? std::optional<std::size_t>(0) : std::nullopt;
  };
  return shrink(start, Breaking{.first = first}, budget);
}

std::vector<Case> simpler_cases(const Case& one) {
  std::vector<Case> all;
  const Simpler simpler(one);
  for (const Move move : moves())
    move(one, [&](const Case& candidate) {
      if (simpler.admits(candidate)) all.push_back(candidate);
    });
  return all;
}

bool is_valid(const Case& one) {
  Case copy = one;
  return std::ranges::all_of(numbers_of(copy), may_be) &&
         std::visit([](const auto& asked) { return is_accepted(asked); }, one.question);
}

}  // namespace rayproof
