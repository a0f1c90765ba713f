#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

/// The ray moved by these shares of the way from its line to the middle.
Cases moved_aside(const Case& one, std::initializer_list<double> shares) {
  Cases all;
  for (const double share : shares) {
    const Cases moved = with_question(one, [share](RayQuestion& asked) {
      const auto middle = middle_of(asked.shape);
      if (!middle) return false;
      const glm::dvec3 place(asked.transform.value_or(glm::dmat4(1)) * glm::dvec4(*middle, 1));
      const glm::dvec3 d = glm::normalize(asked.ray.direction), way = place - asked.ray.origin;
      asked.ray.origin += share * (way - glm::dot(way, d) * d);
      return true;
    });
    all.insert(all.end(), moved.begin(), moved.end());
  }
  return all;
}

}  // namespace

Cases nearer_the_middle(const Case& one) { return moved_aside(one, {0.25, 0.5, 0.75, 0.9}); }
Cases farther_off(const Case& one) { return moved_aside(one, {-0.125, -0.5, -2.0}); }

}  // namespace rayproof::diagnosis
