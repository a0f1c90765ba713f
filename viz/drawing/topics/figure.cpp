#include "viz/drawing/topics/figure.hpp"

#include <algorithm>

namespace rayproof::viz {

World::World(const RayQuestion& question) : x_{1, 0, 0}, y_{0, 1, 0}, z_{0, 0, 1}, translation_{0, 0, 0} {
  if (!question.transform) return;
  const auto column = [&](int i) { return convert<Shadow>(glm::dvec3((*question.transform)[i])); };
  x_ = column(0);
  y_ = column(1);
  z_ = column(2);
  translation_ = column(3);
}

/// A. M. Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions", 1979.
std::vector<WorldPoint> convex_hull(std::vector<WorldPoint> points) {
  const auto is_left_of = [](const WorldPoint& a, const WorldPoint& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::sort(points.begin(), points.end(), is_left_of);
  const auto turns_left = [](const WorldPoint& a, const WorldPoint& b, const WorldPoint& c) {
    return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
  };
  std::vector<WorldPoint> hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= first + 2 && !turns_left(hull[hull.size() - 2], hull.back(), *p)) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // it begins the other chain
  };
  if (points.size() < 3) return points;
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace rayproof::viz
