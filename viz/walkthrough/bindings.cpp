#include "viz/walkthrough/bindings.hpp"

#include <cmath>
#include <map>

namespace rayproof::viz {

const std::vector<Binding>& bindings_of(const std::string& topic) {
  static const std::map<std::string, std::vector<Binding>> tables = [] {
    std::map<std::string, std::vector<Binding>> all;
    for (const auto& [name, table] : topic_bindings) all[name] = table();
    return all;
  }();
  static const std::vector<Binding> none;
  const auto found = tables.find(topic);
  return found == tables.end() ? none : found->second;
}

Binding answer(const char* name) {
  return {name,
          [=](const NumbersByName& n) { return Items{point(Role::claimed, n.at(n.rounded(name)), name)}; }};
}

Binding marked(const char* name, Role role) {
  return {name, [=](const NumbersByName& n) { return Items{point(role, n.vector(name), name)}; }};
}

std::string with_sign(const char* name, const NumbersByName& n) {
  const double number = n.rounded(name);
  return std::string(name) + (number > 0 ? " > 0" : number < 0 ? " < 0" : " = 0");
}

glm::dvec3 resized(const glm::dvec3& v, double length) {
  const double size = glm::length(v);
  return size > 0 ? v * (length / size) : v;
}

glm::dvec3 across(const glm::dvec3& v) {
  const glm::dvec3 other = std::abs(v.z) < 0.9 * glm::length(v) ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return resized(glm::cross(v, other), glm::length(v));
}

Items direction_arrow(const NumbersByName& n) {
  return {arrow(Role::edge, n.origin(), n.origin() + n.direction(), "d")};
}

Items half_chords(const NumbersByName& n) {
  const glm::dvec3 middle = n.at(n["t_c"]);
  return {segment(Role::edge, middle, n.at(n["t_c"] - n["h"]), "h"),
          segment(Role::edge, middle, n.at(n["t_c"] + n["h"]), "h")};
}

Items parameters_from(const NumbersByName& n, const glm::dvec3& corner) {
  const glm::dvec3 beyond = corner + n["α"] * n.vector("u");
  return {segment(Role::edge, corner, beyond, "α·u"),
          segment(Role::edge, beyond, beyond + n["β"] * n.vector("v"), "β·v")};
}

Items way_to_plane(const NumbersByName& n, const glm::dvec3& normal, const glm::dvec3& on_plane) {
  const glm::dvec3 along = resized(normal, 1);
  const glm::dvec3 foot = n.origin() - along * glm::dot(along, n.origin() - on_plane);
  return {segment(Role::nearest, n.origin(), foot, "distance"), point(Role::nearest, foot),
          segment(Role::frame, foot, on_plane, {}, Pattern::dotted)};
}

}  // namespace rayproof::viz
