#include "properties/diagnosis/models/solids/box.hpp"

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/models/first_hit/surface_normals.hpp"

namespace rayproof::diagnosis {
namespace {

std::vector<Case> box_about(const Case& one, double middles, double halves) {
  return with_shape<Box<double>>(one, [=](RayQuestion& /*asked*/, Box<double>& box) {
    const glm::dvec3 middle = middles * (box.min + box.max), half = halves * (box.max - box.min);
    box = {middle - half, middle + half};
    return true;
  });
}

}  // namespace

std::vector<Case> size_as_half(const Case& one) { return box_about(one, 0.5, 1); }
std::vector<Case> half_as_size(const Case& one) { return box_about(one, 0.5, 0.25); }
std::vector<Case> sum_as_middle(const Case& one) { return box_about(one, 1, 0.5); }

std::vector<Case> max_as_half_size(const Case& one) {
  return with_shape<Box<double>>(one, [](RayQuestion& /*asked*/, Box<double>& box) {
    const glm::dvec3 half = glm::abs(box.max);
    box = {-half, half};
    return true;
  });
}

std::vector<Case> with_sides(const Case& one, double (*length)(const glm::dvec3& sides)) {
  return with_shape<Box<double>>(one, [length](RayQuestion& /*asked*/, Box<double>& box) {
    box.max = box.min + length(box.max - box.min);
    return true;
  });
}
std::vector<Case> sides_as_longest(const Case& one) {
  return with_sides(one, [](const glm::dvec3& sides) { return std::max({sides.x, sides.y, sides.z}); });
}

Answers with_corner(const Case& one, Corner corner, void (*change)(glm::dvec3&)) {
  bool is_turned = false;
  const auto changed = with_shape<Box<double>>(one, [&](RayQuestion& /*asked*/, Box<double>& box) {
    change(box.*corner);
    const glm::dvec3 low = glm::min(box.min, box.max), high = glm::max(box.min, box.max);
    is_turned = low != box.min;
    box = {low, high};
    return true;
  });
  Answers answers = exact_of(changed);
  if (is_turned) answers.emplace_back(RayAnswer{});
  return answers;
}

Answers normal_of_farthest_axis(const Case& one, const Answer& exact) {
  const auto* box = shape_in<Box<double>>(one);
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (box == nullptr || answer == nullptr || answer->hits.count == 0) return {};
  const glm::dvec3 point = point_at(ray_in_object(*ray_question(one)), answer->hits.t[0]);
  const glm::dvec3 way = point - 0.5 * (box->min + box->max);
  int axis = 0;
  for (const int other : {1, 2})
    if (std::abs(way[other]) > std::abs(way[axis])) axis = other;
  glm::dvec3 normal(0);
  normal[axis] = std::copysign(1, way[axis]);
  RayAnswer wrong = *answer;
  wrong.normal = glm::normalize(map_of_normals(*ray_question(one)) * normal);
  return {wrong};
}

}  // namespace rayproof::diagnosis
