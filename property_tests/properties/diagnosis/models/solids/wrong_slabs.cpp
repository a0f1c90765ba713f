#include "properties/diagnosis/models/solids/wrong_slabs.hpp"

#include <algorithm>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/solids/slabs.hpp"

namespace rayproof::diagnosis {

Answers slabs_turned_by_origin(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  unsigned turned = 0;
  for (int axis = 0; axis < 3; ++axis)
    if ((cube->ray.origin[axis] > 0) != (cube->ray.direction[axis] < 0))
      turned |= 1U << static_cast<unsigned>(axis);
  const auto slabs = slabs_of(*cube, true, turned);
  if (!slabs || slabs->enters.empty()) return {};
  return inside_from(one, std::ranges::max(slabs->enters), std::ranges::min(slabs->leaves));
}

Answers slab_along_mirrored(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  Cube other = *cube;
  for (int axis = 0; axis < 3; ++axis)
    if (other.ray.direction[axis] == 0) other.ray.origin[axis] *= -1;
  return other.ray.origin == cube->ray.origin ? Answers{} : through_slabs(one, other);
}

Answers first_slab_alone(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  for (int axis = 0; axis < 3; ++axis) {
    const double o = cube->ray.origin[axis], d = cube->ray.direction[axis];
    const double low = cube->low[axis] - o, high = cube->high[axis] - o;
    if (d != 0) return inside_from(one, std::min(low / d, high / d), std::max(low / d, high / d));
    if (low > 0 || high < 0) return {RayAnswer{}};
  }
  return {};
}

Answers missed_from_beyond(const Case& one, const Answer& exact) {
  const auto cube = cube_in(one);
  if (!cube || !finds_something(exact)) return {};
  Answers answers;
  const auto add = [&](bool is_beyond) { answers.push_back(is_beyond ? Answer(RayAnswer{}) : exact); };
  const glm::dvec3& origin = cube->ray.origin;
  for (int axis = 0; axis < 3; ++axis) {
    add(origin[axis] > cube->high[axis]);
    add(origin[axis] < cube->low[axis]);
  }
  add(glm::any(glm::greaterThan(origin, cube->high)));
  add(glm::any(glm::lessThan(origin, cube->low)));
  return std::ranges::any_of(answers, [](const Answer& answer) { return !finds_something(answer); })
             ? answers
             : Answers{};
}

}  // namespace rayproof::diagnosis
