#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <rayproof/formulas/finite.hpp>
#include <stdexcept>

#include "viz/scene/items.hpp"

namespace rayproof::viz {

std::set<std::string> recorded_names(const Walkthrough& walk) {
  std::set<std::string> names;
  for (const WalkStep& step : walk.steps) {
    names.insert(step.title);
    for (const WalkValue& value : step.values) {
      names.insert(value.name);
      if (value.name.ends_with(".x")) names.insert(value.name.substr(0, value.name.size() - 2));
    }
  }
  return names;
}

StageItem level_ring(Role role, double rx, double ry, double z, std::string label) {
  std::vector<glm::dvec3> points;
  constexpr int pieces = 48;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 2 * std::numbers::pi * i / pieces;
    points.emplace_back(rx * std::cos(angle), ry * std::sin(angle), z);
  }
  return polyline(role, std::move(points), std::move(label));
}

glm::dvec3 farthest_of(const StageItem& ellipsoid, const glm::dvec3& direction) {
  const glm::dvec3& centre = ellipsoid.points.at(0);
  glm::dvec3 farthest(0);
  double square = 0;
  for (std::size_t i = 1; i < ellipsoid.points.size(); ++i) {
    const glm::dvec3 a = ellipsoid.points[i] - centre;
    farthest += glm::dot(a, direction) * a;
    square += glm::dot(a, direction) * glm::dot(a, direction);
  }
  return square > 0 ? centre + farthest / std::sqrt(square) : centre;
}

std::vector<glm::dvec3> extent_of(const StageItem& item, const StageCamera& camera) {
  if (item.form != Form::ellipsoid) return item.points;
  return {farthest_of(item, camera.right), farthest_of(item, -camera.right), farthest_of(item, camera.up),
          farthest_of(item, -camera.up)};
}

std::vector<glm::dvec3> extent_of(const std::vector<StageItem>& items, const StageCamera& camera) {
  std::vector<glm::dvec3> all;
  for (const StageItem& item : items) {
    const auto points = extent_of(item, camera);
    all.insert(all.end(), points.begin(), points.end());
  }
  return all;
}

StageView view_of(const std::vector<glm::dvec3>& points, const StageCamera& camera) {
  glm::dvec3 least(std::numeric_limits<double>::infinity());
  glm::dvec3 most = -least;
  for (const glm::dvec3& p : points) {
    if (!rayproof::is_finite(p)) continue;
    const glm::dvec3 seen{glm::dot(p, camera.right), glm::dot(p, camera.up), glm::dot(p, camera.toward)};
    least = glm::min(least, seen);
    most = glm::max(most, seen);
  }
  if (!(least.x <= most.x)) return {};
  const glm::dvec3 half = (most - least) * 0.5;
  const glm::dvec3 middle = least + half;
  const double radius = std::max(half.x / view_aspect, half.y);
  return {middle.x * camera.right + middle.y * camera.up + middle.z * camera.toward, radius > 0 ? radius : 1};
}

double radius_for(const StageView& view, const std::vector<StageItem>& items, const StageCamera& camera) {
  double radius = view.radius;
  for (const glm::dvec3& p : extent_of(items, camera)) {
    const glm::dvec3 off = p - view.centre;
    radius = std::max(
        {radius, std::abs(glm::dot(off, camera.right)) / view_aspect, std::abs(glm::dot(off, camera.up))});
  }
  return radius;
}

}  // namespace rayproof::viz
