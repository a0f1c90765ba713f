#include "properties/diagnosis/models/cylinders/caps.hpp"

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/examination/agreement.hpp"

namespace rayproof::diagnosis {
namespace {

/// The hits on the side and those on the caps, both ascending, of the whole line through a capped cylinder.
struct Parts {
  std::vector<double> side, caps;
};

std::optional<Parts> parts_of(const Case& one, IsInCap is_in_cap) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return std::nullopt;
  const auto open = with_shape<Cylinder<double>>(one, [](RayQuestion& /*asked*/, Cylinder<double>& changed) {
    changed.capped = false;
    return true;
  });
  if (open.empty()) return std::nullopt;
  Parts parts;
  const RayAnswer of_side = hits_of_line(open.front());
  parts.side.assign(of_side.hits.view().begin(), of_side.hits.view().end());
  parts.caps = hits_of_caps(one, *cylinder, is_in_cap);
  return parts;
}

Answers with_caps_where(const Case& one, IsInCap is_in_cap) {
  const auto parts = parts_of(one, is_in_cap);
  if (!parts) return {};
  std::vector<double> all = parts->side;
  all.insert(all.end(), parts->caps.begin(), parts->caps.end());
  return {in_order(one, all)};
}

}  // namespace

Answers caps_of_radius_rx(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(
      one, [](double x, double y, const Cylinder<double>& c) { return std::hypot(x, y) <= c.rx; });
}

Answers caps_of_radius_ry(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(
      one, [](double x, double y, const Cylinder<double>& c) { return std::hypot(x, y) <= c.ry; });
}

Answers caps_of_larger_radius(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(one, [](double x, double y, const Cylinder<double>& c) {
    return std::hypot(x, y) <= std::max(c.rx, c.ry);
  });
}

Answers caps_of_smaller_radius(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(one, [](double x, double y, const Cylinder<double>& c) {
    return std::hypot(x, y) <= std::min(c.rx, c.ry);
  });
}

Answers caps_of_rooted_radius(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(one,
                         [](double x, double y, const Cylinder<double>& c) { return x * x + y * y <= c.rx; });
}

Answers caps_as_diamonds(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(one, [](double x, double y, const Cylinder<double>& c) {
    return std::abs(x) / c.rx + std::abs(y) / c.ry <= 1;
  });
}

Answers caps_outside_outline(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(one, [](double x, double y, const Cylinder<double>& c) {
    return std::pow(x / c.rx, 2) + std::pow(y / c.ry, 2) >= 1;
  });
}

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

namespace {

/// An exact hit on a cap.
struct CapHit {
  double t;
  double share;  ///< of the outline's radius in that direction: 1 at the rim
};

std::vector<CapHit> hits_on_caps(const Case& one, const Answer& exact) {
  std::vector<CapHit> found;
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return found;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const std::vector<double> caps = hits_of_caps(one, *cylinder, is_in_ellipse);
  for (const double hit : std::get<RayAnswer>(exact).hits.view()) {
    const glm::dvec3 place = point_at(ray, hit);
    if (std::ranges::any_of(caps, [&](double t) { return are_close(one.precision, hit, t, std::abs(t)); }))
      found.push_back({hit, std::hypot(place.x / cylinder->rx, place.y / cylinder->ry)});
  }
  return found;
}

}  // namespace

Answers cap_rim_missed(const Case& one, const Answer& exact) {
  constexpr double near_rim = 0.9;
  std::vector<CapHit> near = hits_on_caps(one, exact);
  std::erase_if(near, [](const CapHit& hit) { return hit.share < near_rim; });
  if (near.empty()) return {};
  Answers answers{RayAnswer{}, exact};
  for (const CapHit& hit : near)
    answers.emplace_back(hits_where(std::get<RayAnswer>(exact), [&](double t) { return t != hit.t; }));
  return answers;
}

bool passes_cap_near_rim(const Case& one, const Answer& exact) {
  return std::ranges::any_of(hits_on_caps(one, exact),
                             [](const CapHit& hit) { return hit.share < 1 - 0x1p-14; });
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
