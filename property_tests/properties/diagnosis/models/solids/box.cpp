#include "properties/diagnosis/models/solids/box.hpp"

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/models/first_hit/surface_normals.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

std::vector<Case> box_about(const Case& one, double middles, double halves) {
  return with_shape<Box<double>>(one, [=](RayQuestion& /*asked*/, Box<double>& box) {
    const glm::dvec3 middle = middles * (box.min + box.max), half = halves * (box.max - box.min);
    box = {middle - half, middle + half};
    return true;
  });
}

/// Where the line leaves the slab that it enters at t, or nearest to it.
double last_end_of_entry(const Cube& cube, double t) {
  double last = infinity<double>, least = infinity<double>;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = cube.ray.origin[axis], d = cube.ray.direction[axis];
    const auto [near, far] = std::minmax({(cube.low[axis] - o) / d, (cube.high[axis] - o) / d});
    if (!(std::abs(near - t) < least)) continue;
    least = std::abs(near - t);
    last = far;
  }
  return last;
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

std::optional<bool> normal_signed_by_origin(const Case& one, const Answer& got, const Answer& exact) {
  const auto *mine = std::get_if<RayAnswer>(&got), *answer = std::get_if<RayAnswer>(&exact);
  const auto cube = cube_in(one);
  if (!cube || !mine->normal || answer->hits.count == 0) return std::nullopt;
  const Ray<double>& ray = ray_question(one)->ray;
  const std::vector<glm::dvec3> normals = normals_of_first_hit(one, exact);  // several on an edge
  const auto is_one = [&](const glm::dvec3& normal) {
    return std::ranges::any_of(normals,
                               [&](const glm::dvec3& own) { return glm::length(normal - own) < 0x1p-10; });
  };
  const bool is_turned = !is_one(*mine->normal) && is_one(-*mine->normal);
  const bool enters = glm::dot(is_turned ? -*mine->normal : *mine->normal, ray.direction) < 0;
  if (!enters) return is_turned ? std::optional(false) : std::nullopt;
  const double t = answer->hits.t[0];
  const double rounding = share_of_rounding(one.precision) * size_of_scene(one) / glm::length(ray.direction);
  if (is_turned) return t <= rounding;
  // From beyond both planes of the slab no place of the shape gives the right sign.
  const bool is_beyond = normals.size() == 1 && last_end_of_entry(*cube, t) < -rounding;
  return is_beyond ? std::optional(false) : std::nullopt;
}

Answers normal_of_entry_axis(const Case& one, const Answer& exact) {
  if (shape_in<Box<double>>(one) == nullptr || ray_question(one) == nullptr) return {};
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || answer->hits.count == 0) return {};
  const RayAnswer line = hits_of_line(one);
  if (line.hits.count < 2 || answer->hits.t[0] == line.hits.t[0]) return {};
  Answers answers;
  for (const glm::dvec3& normal : normals_of_first_hit(on_whole_line(one), line)) {
    RayAnswer other = *answer;
    other.normal = -normal;  // of the entry it is against the direction
    answers.emplace_back(other);
  }
  return answers;
}

std::vector<Case> middle_in_float(const Case& one) {
  if (one.precision == Precision::float32) return {};
  return with_shape<Box<double>>(one, [](RayQuestion& /*asked*/, Box<double>& box) {
    const glm::dvec3 middle(glm::vec3(0.5 * (box.min + box.max))), half(glm::vec3(0.5 * (box.max - box.min)));
    box = {middle - half, middle + half};
    return true;
  });
}

}  // namespace rayproof::diagnosis
