#include "viz/walkthrough/bindings.hpp"

namespace rayproof::viz {
namespace {

/// A point of the plane, however it was given.
glm::dvec3 point_of(const NumbersByName& n) {
  if (n.has_vector("p")) return n.vector("p");
  const glm::dvec3 normal = n.vector("n");
  return normal * (-n["D"] / glm::dot(normal, normal));
}

glm::dvec3 normal_of(const NumbersByName& n) { return n.vector(n.has_vector("u×v") ? "u×v" : "n"); }

/// About as long as the distance to the plane: what an arrow needs to be seen.
double reach_of_plane(const NumbersByName& n) {
  const double distance = glm::length(point_of(n) - n.origin());
  return distance > 0 ? 0.45 * distance : glm::length(n.direction());
}

Items normal(const NumbersByName& n) {
  const glm::dvec3 foot = point_of(n);
  return {arrow(Role::normal, foot, foot + resized(normal_of(n), reach_of_plane(n)),
                n.has_vector("u×v") ? "u×v" : "n"),
          point(Role::edge, foot, "p")};
}

Items height_above_plane(const NumbersByName& n) { return way_to_plane(n, normal_of(n), point_of(n)); }

/// How much of it one unit of t goes.
Items gain(const NumbersByName& n) {
  const glm::dvec3 along = resized(normal_of(n), 1);
  const glm::dvec3 tip = n.origin() + n.direction();
  const glm::dvec3 foot = n.origin() + along * glm::dot(along, n.direction());
  return {arrow(Role::edge, n.origin(), tip, "d"), segment(Role::normal, n.origin(), foot, "d along n"),
          segment(Role::frame, foot, tip, {}, Pattern::dotted)};
}

Items spanning(const NumbersByName& n) {
  const glm::dvec3 p = point_of(n);
  return {point(Role::edge, p, "p"), arrow(Role::edge, p, p + n.vector("u"), "u"),
          arrow(Role::edge, p, p + n.vector("v"), "v"), arrow(Role::nearest, p, n.origin(), "w")};
}

Items parameters(const NumbersByName& n) { return parameters_from(n, point_of(n)); }

}  // namespace

std::vector<Binding> plane_bindings() {
  return {
      {"Put the ray into the plane's equation", normal},
      {"Divide the distance by the ray's progress", normal},
      {"n·o + D", height_above_plane},
      {"n·(p - o)", height_above_plane},
      {"n·d", gain},
      {"w", spanning},
      {"u×v", normal},
      {"β", parameters},
      answer("t"),
  };
}

}  // namespace rayproof::viz
