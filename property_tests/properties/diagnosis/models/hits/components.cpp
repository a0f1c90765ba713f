#include "properties/diagnosis/models/hits/components.hpp"

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {

Answers missed_without_component(const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !finds_something(exact)) return {};
  const double rounding = asked->transform ? 0x1p-40 : 0;
  Answers answers;
  for (const glm::dvec3& direction : {asked->ray.direction, ray_in_object(*asked).direction})
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_zero = std::abs(direction[axis]) <= rounding * glm::length(direction);
      answers.push_back(is_zero ? Answer{RayAnswer{}} : exact);
    }
  return answers;
}

std::vector<Case> with_tiny_numbers_as_zero(const Case& one, double least) {
  Case changed = one;
  bool is_changed = false;
  for (const CaseNumber& number : numbers_of(changed))
    if (*number.value != 0 && std::abs(*number.value) < least) {
      *number.value = 0;
      is_changed = true;
    }
  return is_changed && is_valid(changed) ? std::vector{changed} : std::vector<Case>{};
}

}  // namespace rayproof::diagnosis
