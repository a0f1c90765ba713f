#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

glm::dvec3 mean(const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum(0);
  for (const glm::dvec3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// @{ A point about which the shape lies, in object space; none for what has no end.
template <class S>
std::optional<glm::dvec3> middle_of(const S& /*a plane*/) {
  return std::nullopt;
}
std::optional<glm::dvec3> middle_of(const Triangle<double>& t) { return mean({t.a, t.b, t.c}); }
std::optional<glm::dvec3> middle_of(const Polygon<double>& polygon) { return mean(polygon.vertices); }
std::optional<glm::dvec3> middle_of(const Sphere<double>& sphere) { return sphere.center; }
std::optional<glm::dvec3> middle_of(const Box<double>& box) { return mean({box.min, box.max}); }
std::optional<glm::dvec3> middle_of(const Parallelepiped<double>& solid) {
  return solid.corner + 0.5 * (solid.edges[0] + solid.edges[1] + solid.edges[2]);
}
std::optional<glm::dvec3> middle_of(const Cylinder<double>& cylinder) {
  return glm::dvec3(0, 0, cylinder.height / 2);
}
/// @}

/// The ray moved by these shares of the way from its line to the middle.
Cases moved_aside(const Case& one, std::initializer_list<double> shares) {
  Cases all;
  for (const double share : shares) {
    const Cases moved = with_question(one, [share](RayQuestion& asked) {
      const auto middle = std::visit([](const auto& shape) { return middle_of(shape); }, asked.shape);
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
