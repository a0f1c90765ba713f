#include "properties/diagnosis/models/outlines/small_box.hpp"

#include <array>

#include "properties/diagnosis/models/outlines/outline.hpp"

namespace rayproof::diagnosis {

Answers outside_small_box(const Case& one, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  const bool is_on_boundary = position != nullptr && *position == Position::boundary;
  if (is_on_boundary || shape_in<Triangle<double>>(one) != nullptr) return {};
  const auto hit = point_and_outline(one);
  if (!hit || is_at_side(one.precision, hit->point, hit->vertices)) return {};
  const bool is_in = is_inside_outline(*hit);
  const Outline& all = hit->vertices;
  Answers answers;
  for (const Outline& left :
       {Outline(all.begin() + 1, all.end()), Outline(all.begin(), all.end() - 1), Outline{all[0], all[1]},
        Outline{all[0], all[2]}, Outline{all[0], all.back()}}) {
    const auto [low, high] = bounds_of(left);
    const glm::dvec2& p = hit->point;
    const std::array beyond{p.x<low.x, p.x> high.x, p.y<low.y, p.y> high.y};
    answers.push_back(place_at(one, *hit, is_in && is_in_bounds(p, left)).front());
    for (const bool is_beyond : beyond) answers.push_back(place_at(one, *hit, is_in && !is_beyond).front());
  }
  return answers;
}

}  // namespace rayproof::diagnosis
