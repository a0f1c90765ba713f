#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <rayproof/formulas/finite.hpp>
#include <stdexcept>

#include "viz/scene/items.hpp"

namespace rayproof::viz {

namespace {

double find(const std::map<std::string, double>& numbers, const std::string& name) {
  const auto found = numbers.find(name);
  if (found == numbers.end()) throw std::logic_error("no kernel of this run names " + name);
  return found->second;
}

}  // namespace

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

NumbersByName::NumbersByName(const Walkthrough& walk, std::size_t last_step) {
  for (const WalkValue& value : walk.inputs) take(value);
  for (std::size_t i = 0; i <= last_step && i < walk.steps.size(); ++i) {
    for (const WalkValue& value : walk.steps[i].values) take(value);
  }
}

void NumbersByName::take(const WalkValue& value) {
  first_.try_emplace(value.name, value.exact_value);
  exact_[value.name] = value.exact_value;
  rounded_[value.name] = value.value;
}

double NumbersByName::operator[](const std::string& name) const { return find(exact_, name); }
double NumbersByName::rounded(const std::string& name) const { return find(rounded_, name); }

glm::dvec3 NumbersByName::vector(const std::string& name) const {
  const auto in_space = [&](const std::string& component) {
    return has(component) ? (*this)[component] : 0.0;
  };
  return {(*this)[name + ".x"], (*this)[name + ".y"], in_space(name + ".z")};
}

glm::dvec3 NumbersByName::first_vector(const std::string& name) const {
  return {find(first_, name + ".x"), find(first_, name + ".y"), find(first_, name + ".z")};
}

glm::dvec3 NumbersByName::origin() const { return first_vector(has_vector("o′") ? "o′" : "o"); }

// A plane has a d of its own; beside it the direction bears an arrow. A kernel may name a d of its own later.
glm::dvec3 NumbersByName::direction() const { return first_vector("d"); }

/// Of centre + Σ cᵢ·aᵢ with |c| = 1.
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
