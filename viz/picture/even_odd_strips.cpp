#include "viz/picture/even_odd_strips.hpp"

#include <algorithm>
#include <set>

namespace rayproof::viz {
namespace {

/// A side that is not level, from its least to its greatest y.
struct Slant {
  Point low, high;
  [[nodiscard]] double at(double y) const {
    return low.x + (high.x - low.x) * std::clamp((y - low.y) / (high.y - low.y), 0.0, 1.0);
  }
};

/// On which side of the line from a to b the point lies, by the sign.
double side_of(const Point& a, const Point& b, const Point& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// The levels of the places where two sides cross.
std::set<double> crossings_of(const std::vector<Point>& ring) {
  std::set<double> levels;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Point &a = ring[i], &b = ring[(i + 1) % n], &c = ring[j], &d = ring[(j + 1) % n];
      const double before = side_of(a, b, c), after = side_of(a, b, d);
      const bool is_crossed = before * after < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
      if (is_crossed) levels.insert(c.y + (d.y - c.y) * before / (before - after));
    }
  }
  return levels;
}

}  // namespace

std::vector<Strip> even_odd_strips(const std::vector<Point>& ring) {
  std::set<double> levels = crossings_of(ring);
  if (levels.empty()) return {};
  std::vector<Slant> sides;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    levels.insert(a.y);
    if (a.y != b.y) sides.push_back(a.y < b.y ? Slant{a, b} : Slant{b, a});
  }
  std::vector<Strip> strips;
  for (auto level = levels.begin(); std::next(level) != levels.end(); ++level) {
    const double low = *level, high = *std::next(level), middle = (low + high) / 2;
    std::vector<const Slant*> across;
    for (const Slant& side : sides)
      if (side.low.y <= middle && middle < side.high.y) across.push_back(&side);
    std::sort(across.begin(), across.end(),
              [&](const Slant* a, const Slant* b) { return a->at(middle) < b->at(middle); });
    for (std::size_t i = 0; i + 1 < across.size(); i += 2) {
      const Slant &left = *across[i], &right = *across[i + 1];
      strips.push_back(
          {{{left.at(low), low}, {right.at(low), low}, {right.at(high), high}, {left.at(high), high}}});
    }
  }
  return strips;
}

}  // namespace rayproof::viz
