#include <algorithm>
#include <cmath>

#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

void append(Cases& all, const Cases& more) { all.insert(all.end(), more.begin(), more.end()); }

/// The share of the scene by which a ray is moved aside.
double step_of(const Case& one) { return one.precision == Precision::float32 ? 0x1p-14 : 0x1p-20; }

/// Points in the plane moved along both axes, either way.
Cases nudged(const Case& one, const PointAndPolygon<double>& place, double step) {
  double size = 0;
  for (const auto& vertex : place.vertices)
    size = std::max({size, std::abs(vertex.x - place.point.x), std::abs(vertex.y - place.point.y)});
  Cases all;
  for (const auto& [x, y] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
    Case changed = one;
    auto& point = std::get<PointAndPolygon<double>>(changed.question).point;
    point.x += x * step * size;
    point.y += y * step * size;
    append(all, if_valid(std::move(changed)));
  }
  return all;
}

/// The coefficients of an equation each made a little larger or smaller.
Cases nudged(const Case& one, const Quadratic<double>& /*equation*/, double step) {
  Cases all;
  for (const double sign : {1.0, -1.0}) {
    Case changed = one;
    std::get<Quadratic<double>>(changed.question).c *= 1 + sign * step;
    append(all, if_valid(std::move(changed)));
  }
  return all;
}

/// Rays moved aside along two directions across their own, either way.
Cases nudged(const Case& one, const RayQuestion& asked, double step) {
  const glm::dvec3 d = glm::normalize(asked.ray.direction);
  const glm::dvec3 across =
      glm::normalize(std::abs(d.x) < 0.6 ? glm::cross(d, {1, 0.4, 0.2}) : glm::cross(d, {0.3, 1, 0.5}));
  const glm::dvec3 other = glm::cross(d, across);
  const double by = step * size_of_scene(one);
  Cases all;
  for (const glm::dvec3& aside : {across, -across, other, -other})
    append(all, with_question(one, [&](RayQuestion& changed) {
             changed.ray.origin += by * aside;
             return true;
           }));
  return all;
}

}  // namespace

Cases off_boundary(const Case& one) {
  return std::visit([&](const auto& asked) { return nudged(one, asked, step_of(one)); }, one.question);
}

namespace {

/// Whether the line is met so near an end of the interval that rounding may put it there.
bool has_hit_at_an_end(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return false;
  const HitList line = hits_of_line(one).hits;
  return std::ranges::any_of(line.view(), [&](double t) {
    const auto is_near = [&](double end) {
      return std::isfinite(end) && std::abs(t - end) <= step_of(one) * (std::abs(t) + std::abs(end));
    };
    return is_near(asked->ray.t_min) || is_near(asked->ray.t_max);
  });
}

}  // namespace

Cases off_interval_ends(const Case& one) {
  if (!has_hit_at_an_end(one)) return {};
  return with_question(one, [&](RayQuestion& asked) {
    const double by = 1 + step_of(one);
    const auto lower = [&](double t) { return t == 0 ? -step_of(one) : t > 0 ? t / by : t * by; };
    asked.ray.t_min = lower(asked.ray.t_min);
    asked.ray.t_max = -lower(-asked.ray.t_max);
    return true;
  });
}

Cases off_level(const Case& one) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  if (place == nullptr) return {};
  bool is_level = false;
  for (const auto& vertex : place->vertices) is_level = is_level || vertex.y == place->point.y;
  return is_level ? nudged(one, *place, step_of(one)) : Cases{};
}

}  // namespace rayproof::diagnosis
