#include "properties/diagnosis/models/cylinders/caps.hpp"

#include <algorithm>
#include <cmath>

namespace rayproof::diagnosis {
Answers caps_at_opposite_t(const Case& one, const Answer& /*exact*/) {
  const auto parts = parts_of(one, is_in_ellipse);
  if (!parts) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const auto& cylinder = *shape_in<Cylinder<double>>(one);
  std::vector<double> all = parts->side;
  for (const double z : {0.0, cylinder.height}) {
    const double t = (ray.origin.z - z) / ray.direction.z;
    const glm::dvec3 point = point_at(ray, t);
    if (ray.direction.z != 0 && is_in_ellipse(point.x, point.y, cylinder)) all.push_back(t);
  }
  return {in_order(one, all)};
}

Answers caps_by_origin(const Case& one, const Answer& /*exact*/) {
  const auto parts = parts_of(one, [](double, double, const Cylinder<double>&) { return true; });
  if (!parts) return {};
  const glm::dvec3 origin = ray_in_object(*ray_question(one)).origin;
  std::vector<double> all = parts->side;
  if (is_in_ellipse(origin.x, origin.y, *shape_in<Cylinder<double>>(one)))
    all.insert(all.end(), parts->caps.begin(), parts->caps.end());
  std::ranges::sort(all);
  // There may be three or four; the first and the last of the line are taken then, or of the interval.
  return {in_order(one, all.size() > 2 ? std::vector{all.front(), all.back()} : all), in_order(one, all)};
}

namespace {

/// Both caps are hit where the ray's point at that share of the height is within the outline.
Answers caps_by_point_at(const Case& one, double share_of_height) {
  const auto parts = parts_of(one, [](double, double, const Cylinder<double>&) { return true; });
  const Ray<double> ray = parts ? ray_in_object(*ray_question(one)) : Ray<double>{};
  if (!parts || ray.direction.z == 0) return {};
  const auto& cylinder = *shape_in<Cylinder<double>>(one);
  const glm::dvec3 point =
      point_at(ray, (share_of_height * cylinder.height - ray.origin.z) / ray.direction.z);
  std::vector<double> all = parts->side;
  if (is_in_ellipse(point.x, point.y, cylinder))
    all.insert(all.end(), parts->caps.begin(), parts->caps.end());
  std::ranges::sort(all);
  // There may be three, of which the first and the last may be taken.
  return {in_order(one, all), in_order(one, all.size() > 2 ? std::vector{all.front(), all.back()} : all)};
}

}  // namespace

Answers upper_cap_by_lower_point(const Case& one, const Answer& /*exact*/) {
  return caps_by_point_at(one, 0);
}
Answers lower_cap_by_upper_point(const Case& one, const Answer& /*exact*/) {
  return caps_by_point_at(one, 1);
}

Answers caps_from_outside_alone(const Case& one, const Answer& /*exact*/) {
  const auto parts = parts_of(one, is_in_ellipse);
  if (!parts) return {};
  std::vector<double> all = parts->side;
  const bool enters_through_cap =
      !parts->caps.empty() && (parts->caps.size() == 2 || all.empty() || parts->caps.front() < all.front());
  if (enters_through_cap) all.push_back(parts->caps.front());
  return {in_order(one, all)};
}

Answers first_cap_alone(const Case& one, const Answer& /*exact*/) {
  const auto parts = parts_of(one, is_in_ellipse);
  if (!parts || parts->caps.size() < 2) return {};
  // Ascending: of a ray that runs upward the lower cap is the first.
  const bool is_upward = ray_in_object(*ray_question(one)).direction.z > 0;
  std::vector<double> all = parts->side;
  all.push_back(is_upward ? parts->caps.front() : parts->caps.back());
  return {in_order(one, all)};
}

Answers side_before_caps(const Case& one, const Answer& /*exact*/) {
  const auto parts = parts_of(one, is_in_ellipse);
  if (!parts) return {};
  const RayAnswer side = in_order(one, parts->side);
  RayAnswer nearest = side.hits.count > 0 ? side : in_order(one, parts->caps);
  nearest.hits.count = std::min<std::size_t>(nearest.hits.count, 1);
  return {nearest};
}

}  // namespace rayproof::diagnosis
