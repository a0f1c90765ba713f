#include "properties/diagnosis/models/flat/plane_end.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {

Answers plane_ends(const Case& one, const Answer& exact) {
  if (topic_of(one) != "plane" || !finds_something(exact)) return {};
  const glm::dvec3 hit = glm::abs(point_at(ray_question(one)->ray, std::get<RayAnswer>(exact).hits.t[0]));
  const std::array far{std::max(hit.x, hit.y), std::max(hit.x, hit.z), std::max(hit.y, hit.z),
                       std::max({hit.x, hit.y, hit.z}), glm::length(hit)};
  Answers answers;
  for (const double end : {1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6})
    for (const double distance : far) answers.push_back(distance > end ? Answer{RayAnswer{}} : exact);
  return answers;
}

}  // namespace rayproof::diagnosis
