#include "properties/diagnosis/models/solids/box.hpp"

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
std::vector<Case> sum_as_middle(const Case& one) { return box_about(one, 1, 0.5); }

std::vector<Case> max_as_half_size(const Case& one) {
  return with_shape<Box<double>>(one, [](RayQuestion& /*asked*/, Box<double>& box) {
    const glm::dvec3 half = glm::abs(box.max);
    box = {-half, half};
    return true;
  });
}

Answers with_corner_copied(const Case& one, glm::dvec3 Box<double>::*corner, int from, int to) {
  bool is_turned = false;
  const auto changed = with_shape<Box<double>>(one, [&](RayQuestion& /*asked*/, Box<double>& box) {
    (box.*corner)[to] = (box.*corner)[from];
    is_turned = box.min[to] > box.max[to];
    if (is_turned) std::swap(box.min[to], box.max[to]);
    return true;
  });
  Answers answers = exact_of(changed);
  if (is_turned) answers.emplace_back(RayAnswer{});
  return answers;
}

}  // namespace rayproof::diagnosis
