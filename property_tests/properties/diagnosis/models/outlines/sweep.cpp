#include "properties/diagnosis/models/outlines/sweep.hpp"

#include <utility>

namespace rayproof::diagnosis {

Answers place_at(const Case& one, const PlaneHit& seen, bool is_inside) {
  if (ray_question(one) != nullptr) return hit_at(one, seen.t, is_inside);
  return {is_inside ? Position::inside : Position::outside};
}

PlaneHit upside_down(PlaneHit seen) {
  seen.point.y = -seen.point.y;
  for (glm::dvec2& vertex : seen.vertices) vertex.y = -vertex.y;
  return seen;
}

PlaneHit swept(Sweep sweep, PlaneHit hit) {
  const bool is_in_order = sweep == Sweep::along_in_order || sweep == Sweep::against_in_order;
  const bool is_across = sweep == Sweep::upward || sweep == Sweep::downward;
  const bool is_against =
      sweep == Sweep::against || sweep == Sweep::against_in_order || sweep == Sweep::downward;
  const auto turned = [&](glm::dvec2 v) {
    if (is_across || (is_in_order && hit.axis == 1)) std::swap(v.x, v.y);
    return glm::dvec2(is_against ? -v.x : v.x, v.y);
  };
  hit.point = turned(hit.point);
  for (glm::dvec2& vertex : hit.vertices) vertex = turned(vertex);
  return hit;
}

}  // namespace rayproof::diagnosis
