#include "viz/stage/bindings.hpp"

namespace rayproof::viz {
namespace {

/// A point on the sphere, in the direction of the ray point nearest the centre.
glm::dvec3 nearest_on_sphere(const NumbersByName& n) {
  const glm::dvec3 l = n.vector("l");
  const double length = glm::length(l);
  const glm::dvec3 across = glm::cross(n.direction(), glm::dvec3(0.36, 0.48, 0.8));
  const glm::dvec3 out = length > 0 ? l / length : across / glm::length(across);
  return n.vector("C") + n["r"] * out;
}

}  // namespace

std::vector<Binding> sphere_bindings() {
  return {
      {"f", [](const NumbersByName& n) { return Items{arrow(Role::edge, n.vector("C"), n.origin(), "f")}; }},
      {"t_c", [](const NumbersByName& n) { return Items{point(Role::nearest, n.at(n["t_c"]), "t_c")}; }},
      {"l",
       [](const NumbersByName& n) {
         return Items{arrow(Role::nearest, n.vector("C"), n.vector("C") + n.vector("l"), "l")};
       }},
      {"D",
       [](const NumbersByName& n) {
         if (!n.has_vector("l")) return Items{};
         return Items{segment(Role::edge, n.vector("C"), nearest_on_sphere(n), "r", Pattern::dashed)};
       }},
      {"h",
       [](const NumbersByName& n) {
         return Items{segment(Role::edge, n.at(n["t_c"] - n["h"]), n.at(n["t_c"] + n["h"]), "h")};
       }},
  };
}

}  // namespace rayproof::viz
