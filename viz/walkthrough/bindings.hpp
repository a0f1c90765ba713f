#pragma once
/// \file
/// The registration of the bindings: each topic's table of how its named values look, a function and a line.

#include <cmath>

#include "viz/scene/items.hpp"

namespace rayproof::viz {

[[nodiscard]] std::vector<Binding> plane_bindings();
[[nodiscard]] std::vector<Binding> triangle_bindings();
[[nodiscard]] std::vector<Binding> sphere_bindings();
[[nodiscard]] std::vector<Binding> cylinder_bindings();
[[nodiscard]] std::vector<Binding> box_bindings();
[[nodiscard]] std::vector<Binding> parallelepiped_bindings();
[[nodiscard]] std::vector<Binding> quadratic_bindings();

/// A method's answer, which looks alike in every topic: a point on the ray where the rounded arithmetic has
/// it.
[[nodiscard]] inline Binding answer(const char* name) {
  return {name,
          [=](const NumbersByName& n) { return Items{point(Role::claimed, n.at(n.rounded(name)), name)}; }};
}

/// A vector that is a place: its point, with its name.
[[nodiscard]] inline Binding marked(const char* name, Role role) {
  return {name, [=](const NumbersByName& n) { return Items{point(role, n.vector(name), name)}; }};
}

/// "W > 0": the sign of a number as the kernel has it.
[[nodiscard]] inline std::string with_sign(const char* name, const NumbersByName& n) {
  const double number = n.rounded(name);
  return std::string(name) + (number > 0 ? " > 0" : number < 0 ? " < 0" : " = 0");
}

struct TopicBindings {
  const char* topic;
  std::vector<Binding> (*table)();
};
inline constexpr TopicBindings topic_bindings[] = {
    {"plane", plane_bindings},                    //
    {"triangle", triangle_bindings},              //
    {"sphere", sphere_bindings},                  //
    {"cylinder", cylinder_bindings},              //
    {"box", box_bindings},                        //
    {"parallelepiped", parallelepiped_bindings},  //
    {"quadratic", quadratic_bindings},            //
};

[[nodiscard]] inline std::vector<Binding> bindings_of(const std::string& topic) {
  for (const auto& [name, table] : topic_bindings)
    if (topic == name) return table();
  return {};
}

/// `v` with the length `length`: of what has the direction of an arrow but, being an area, no length.
[[nodiscard]] inline glm::dvec3 resized(const glm::dvec3& v, double length) {
  const double size = glm::length(v);
  return size > 0 ? v * (length / size) : v;
}

[[nodiscard]] inline glm::dvec3 across(const glm::dvec3& v) {
  const glm::dvec3 other = std::abs(v.z) < 0.9 * glm::length(v) ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return resized(glm::cross(v, other), glm::length(v));
}
[[nodiscard]] inline Items direction_arrow(const NumbersByName& n) {
  return {arrow(Role::edge, n.origin(), n.origin() + n.direction(), "d")};
}

/// The chord of a round shape, as the centred methods have it: t_c in its middle, h to either side.
[[nodiscard]] inline Items half_chords(const NumbersByName& n) {
  const glm::dvec3 middle = n.at(n["t_c"]);
  return {segment(Role::edge, middle, n.at(n["t_c"] - n["h"]), "h"),
          segment(Role::edge, middle, n.at(n["t_c"] + n["h"]), "h")};
}

/// From a corner along u and v to the point of the plane with these parameters.
[[nodiscard]] inline Items parameters_from(const NumbersByName& n, const glm::dvec3& corner) {
  const glm::dvec3 beyond = corner + n["α"] * n.vector("u");
  return {segment(Role::edge, corner, beyond, "α·u"),
          segment(Role::edge, beyond, beyond + n["β"] * n.vector("v"), "β·v")};
}

/// From the ray's origin straight to the plane through `on_plane`, and on in the plane to that point.
[[nodiscard]] inline Items way_to_plane(const NumbersByName& n, const glm::dvec3& normal,
                                        const glm::dvec3& on_plane) {
  const glm::dvec3 along = resized(normal, 1);
  const glm::dvec3 foot = n.origin() - along * glm::dot(along, n.origin() - on_plane);
  return {segment(Role::nearest, n.origin(), foot, "distance"), point(Role::nearest, foot),
          segment(Role::frame, foot, on_plane, {}, Pattern::dotted)};
}

}  // namespace rayproof::viz
