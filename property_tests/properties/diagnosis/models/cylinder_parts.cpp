#include "properties/diagnosis/models/cylinder_parts.hpp"

#include <algorithm>
#include <cmath>

namespace rayproof::diagnosis {

bool is_in_ellipse(double x, double y, const Cylinder<double>& c) {
  return std::pow(x / c.rx, 2) + std::pow(y / c.ry, 2) <= 1;
}

std::vector<double> hits_of_caps(const Case& one, const Cylinder<double>& cylinder, IsInCap is_in_cap,
                                 double upper) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  std::vector<double> caps;
  if (ray.direction.z == 0) return caps;
  for (const double z : {0.0, upper}) {
    const double t = (z - ray.origin.z) / ray.direction.z;
    const glm::dvec3 place = point_at(ray, t);
    if (is_in_cap(place.x, place.y, cylinder)) caps.push_back(t);
  }
  std::ranges::sort(caps);
  return caps;
}

RayAnswer in_order(const Case& one, std::vector<double> hits) {
  std::ranges::sort(hits);
  RayAnswer line;
  for (const double t : hits)
    if (line.hits.count < line.hits.t.size() && in_interval(ray_question(one)->ray, t))
      line.hits.push_back(t);
  return line;
}

Answers with_side_hits(const Case& one, std::vector<double> side, const SideEnds& ends) {
  const auto& cylinder = *shape_in<Cylinder<double>>(one);
  const Ray<double> ray = ray_in_object(*ray_question(one));
  std::erase_if(side, [&](double t) {
    const double z = ray.origin.z + t * ray.direction.z;
    return !(-ends.below <= z && z <= cylinder.height + ends.above);
  });
  const std::vector<double> caps =
      cylinder.capped ? hits_of_caps(one, cylinder, is_in_ellipse) : std::vector<double>{};
  side.insert(side.end(), caps.begin(), caps.end());
  return {in_order(one, std::move(side))};
}

std::optional<HitsOfParts> parts_of(const Case& one, IsInCap is_in_cap) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  if (cylinder == nullptr || !cylinder->capped) return std::nullopt;
  const auto open = with_shape<Cylinder<double>>(one, [](RayQuestion& /*asked*/, Cylinder<double>& changed) {
    changed.capped = false;
    return true;
  });
  if (open.empty()) return std::nullopt;
  HitsOfParts parts;
  const RayAnswer of_side = hits_of_line(open.front());
  parts.side.assign(of_side.hits.view().begin(), of_side.hits.view().end());
  parts.caps = hits_of_caps(one, *cylinder, is_in_cap);
  return parts;
}

RayAnswer between_ends(const Case& one, double entry, double exit, double upper) {
  const auto& cylinder = *shape_in<Cylinder<double>>(one);
  if (!cylinder.capped) return std::get<RayAnswer>(with_side_hits(one, {entry, exit}).front());
  const auto anywhere = [](double /*x*/, double /*y*/, const Cylinder<double>&) { return true; };
  const std::vector<double> ends = hits_of_caps(one, cylinder, anywhere, upper);
  if (ends.size() == 2) {
    entry = std::max(entry, ends[0]);
    exit = std::min(exit, ends[1]);
  }
  return entry <= exit ? in_order(one, {entry, exit}) : RayAnswer{};
}

}  // namespace rayproof::diagnosis
