#include "properties/diagnosis/models/solids/apart.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "properties/diagnosis/changes.hpp"

namespace rayproof::diagnosis {
namespace {

/// A capped cylinder whose outline is a circle, or null.
const Cylinder<double>* round_cylinder_in(const Case& one) {
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  return cylinder != nullptr && cylinder->capped && cylinder->rx == cylinder->ry ? cylinder : nullptr;
}

}  // namespace

double thickness_of(const Case& one) {
  if (const auto* sphere = shape_in<Sphere<double>>(one)) return 2 * sphere->radius;
  if (const auto* cylinder = round_cylinder_in(one)) return std::min(cylinder->height, 2 * cylinder->rx);
  const auto* box = shape_in<Box<double>>(one);
  if (box == nullptr) return 0;
  const glm::dvec3 sides = box->max - box->min;
  return std::min({sides.x, sides.y, sides.z});
}

std::optional<Apart> Apart::from(const Case& one, double margin) {
  if (!(2 * margin < thickness_of(one))) return std::nullopt;
  Apart made;
  if (const auto* sphere = shape_in<Sphere<double>>(one)) {
    made.low_ = made.high_ = sphere->center;
    made.radius_ = sphere->radius - margin;
  } else if (const auto* cylinder = round_cylinder_in(one)) {
    made.is_about_axis_ = true;
    made.low_ = {-(cylinder->rx - margin), 0, margin};
    made.high_ = {cylinder->rx - margin, 0, cylinder->height - margin};
  } else {
    const auto* box = shape_in<Box<double>>(one);
    made.low_ = box->min + margin;
    made.high_ = box->max - margin;
  }
  return made;
}

double Apart::at(const glm::dvec3& point) const {
  const glm::dvec3 seen = is_about_axis_ ? glm::dvec3(std::hypot(point.x, point.y), 0, point.z) : point;
  const double apart = glm::length(glm::max(glm::max(low_ - seen, seen - high_), 0.0));
  return std::max(apart - radius_, 0.0);
}

double Apart::least(const Ray<double>& ray, double from, double to) const {
  for (int step = 0; step < 100; ++step) {
    const double before = from + (to - from) / 3, after = to - (to - from) / 3;
    if (at(point_at(ray, before)) <= at(point_at(ray, after)))
      to = after;
    else
      from = before;
  }
  return at(point_at(ray, (from + to) / 2));
}

}  // namespace rayproof::diagnosis
