#include "properties/diagnosis/models/cylinders/cap_outlines.hpp"

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/cylinder_parts.hpp"

namespace rayproof::diagnosis {
namespace {

Answers with_caps_where(const Case& one, IsInCap is_in_cap) {
  const auto parts = parts_of(one, is_in_cap);
  if (!parts) return {};
  std::vector<double> all = parts->side;
  all.insert(all.end(), parts->caps.begin(), parts->caps.end());
  // Who looks for the solid's first hit alone there leaves off where that is on a cap which is not found, and
  // finds its last one wherever that is.
  std::vector<double> real = hits_of_caps(one, *shape_in<Cylinder<double>>(one), is_in_ellipse);
  const bool is_entry_lost = std::ranges::any_of(
      real, [&](double t) { return std::ranges::none_of(all, [t](double found) { return found <= t; }); });
  real.insert(real.end(), parts->side.begin(), parts->side.end());
  return {in_order(one, all), is_entry_lost ? RayAnswer{} : in_order(one, real)};
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

Answers caps_of_exchanged_radii(const Case& one, const Answer& /*exact*/) {
  return with_caps_where(one, [](double x, double y, const Cylinder<double>& c) {
    return c.rx == c.ry ? std::hypot(x, y) <= c.rx : std::hypot(x / c.ry, y / c.rx) <= 1;
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

}  // namespace rayproof::diagnosis
