#include <algorithm>
#include <array>
#include <cmath>

#include "viz/walkthrough/bindings.hpp"

namespace rayproof::viz {
namespace {

/// The stretches of the ray between each pair of planes, side by side along the ray: where all three overlap,
/// it is in the box.
Items slabs(const NumbersByName& n) {
  const glm::dvec3 below = n.vector("min - o");
  const glm::dvec3 above = n.vector("max - o");
  const glm::dvec3 d = n.direction();
  const glm::dvec3 aside = resized(across(d), 0.25 * glm::length(above - below));
  constexpr std::array<const char*, 3> names{"x", "y", "z"};
  Items items;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) continue;
    const double first = below[axis] / d[axis];
    const double second = above[axis] / d[axis];
    const glm::dvec3 off = static_cast<double>(items.size() + 1) * aside;
    items.push_back(segment(Role::edge, n.at(std::min(first, second)) + off,
                            n.at(std::max(first, second)) + off,
                            "in the " + std::string(names.at(static_cast<std::size_t>(axis))) + " slab"));
  }
  return items;
}

/// The stretch that all have in common, where there is one.
Items overlap(const NumbersByName& n) {
  if (!(n["t_entry"] < n["t_exit"])) return {};
  return {segment(Role::nearest, n.at(n["t_entry"]), n.at(n["t_exit"]), "inside all three slabs")};
}

Items to_corner(const NumbersByName& n, const char* name) {
  return {arrow(Role::edge, n.origin(), n.origin() + n.vector(name), name)};
}

Binding face_normal(const char* name, const char* first, const char* second) {
  return {name, [=](const NumbersByName& n) {
            const glm::dvec3 middle = n.vector("corner") + 0.5 * (n.vector(first) + n.vector(second));
            const double length = 0.5 * std::max(glm::length(n.vector(first)), glm::length(n.vector(second)));
            return Items{arrow(Role::normal, middle, middle + resized(n.vector(name), length), name)};
          }};
}

Items ring(double rx, double ry, double z, const char* label) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= 48; ++i) {
    const double angle = i * 0.13089969389957472;
    points.emplace_back(rx * std::cos(angle), ry * std::sin(angle), z);
  }
  return {polyline(Role::edge, points, label)};
}

Items ends(const NumbersByName& n) {
  Items items = ring(n["rx"], n["ry"], 0, "");  // the scene names it
  for (StageItem& item : ring(n["rx"], n["ry"], n["height"], "z = height")) items.push_back(std::move(item));
  return items;
}

/// The stretch of the ray between both ends, where it has one.
Items between_both_ends(const NumbersByName& n) {
  if (!std::isfinite(n["e₀"]) || !std::isfinite(n["e₁"])) return {};
  return {segment(Role::nearest, n.at(n["e₀"]), n.at(n["e₁"]), "from e₀ to e₁")};
}

Items semi_axes(const NumbersByName& n) {
  return {arrow(Role::edge, {0, 0, 0}, {n["rx"], 0, 0}, "rx"),
          arrow(Role::edge, {0, 0, 0}, {0, n["ry"], 0}, "ry")};
}

/// From the axis to the ray's point nearest it, in the measure of the ellipse.
Items nearest_the_axis(const NumbersByName& n) {
  const glm::dvec3 nearest = n.at(n["t_c"]);
  return {point(Role::nearest, nearest, "t_c"), segment(Role::nearest, {0, 0, nearest.z}, nearest, "l")};
}

}  // namespace

std::vector<Binding> box_bindings() {
  return {
      {"min - o", [](const NumbersByName& n) { return to_corner(n, "min - o"); }},
      {"max - o", [](const NumbersByName& n) { return to_corner(n, "max - o"); }},
      {"Meet both planes of each axis", slabs},
      {"t_exit", overlap},
      answer("t_entry"),
      answer("t_exit"),
  };
}

std::vector<Binding> parallelepiped_bindings() {
  return {
      face_normal("n₀", "e₁", "e₂"),
      face_normal("n₁", "e₂", "e₀"),
      face_normal("n₂", "e₀", "e₁"),
      {"Meet each pair of faces", [](const NumbersByName& n) { return to_corner(n, "f"); }},
      {"t_exit", overlap},
      answer("t_entry"),
      answer("t_exit"),
  };
}

std::vector<Binding> cylinder_bindings() {
  return {
      {"Scale the ellipse to the unit circle", semi_axes},
      {"t_c", nearest_the_axis},
      {"h", half_chords},
      {"Meet the planes of both ends", ends},
      answer("s₀"),
      answer("s₁"),
      {"Keep the roots between both ends", between_both_ends},
      {"Keep what lies on the segment, as printed",
       [](const NumbersByName& n) {
         return Items{segment(Role::nearest, n.at(0), n.at(1), "t from 0 to 1")};
       }},
      answer("t_entry"),
      answer("t_exit"),
  };
}

}  // namespace rayproof::viz
