#include <algorithm>
#include <array>
#include <cmath>

#include "viz/walkthrough/bindings.hpp"

namespace rayproof::viz {
namespace {

/// Two parallel planes, each by the face that `u` and `v` span at a corner, widened to where the ray meets
/// it, and the stretch of the ray between them. A place far off is left out; nothing is left of planes that
/// the ray meets nowhere else, but it may be parallel to them.
Items slab(const NumbersByName& n, const std::array<glm::dvec3, 2>& corners, const glm::dvec3& u,
           const glm::dvec3& v, const std::array<std::string, 2>& names) {
  constexpr double margin = 0.2, farthest = 2.5;  // in edges
  const glm::dvec3 normal = glm::cross(u, v);
  const bool is_backward = glm::dot(corners[1] - corners[0], normal) * glm::dot(n.direction(), normal) < 0;
  Items planes, marks;
  for (std::size_t i = 0; i < 2; ++i) {
    const double t = glm::dot(corners.at(i) - n.origin(), normal) / glm::dot(n.direction(), normal);
    const glm::dvec3 off = n.at(t) - corners.at(i);
    const double a = glm::dot(glm::cross(off, v), normal) / glm::dot(normal, normal);
    const double b = glm::dot(glm::cross(u, off), normal) / glm::dot(normal, normal);
    const bool is_near = std::abs(a - 0.5) < farthest && std::abs(b - 0.5) < farthest;
    if (is_near) marks.push_back(point(Role::nearest, n.at(t), names.at(is_backward ? 1 - i : i)));
    if (std::isfinite(t) && !is_near) continue;
    const double u_from = std::min(0.0, is_near ? a : 0) - margin,
                 u_to = std::max(1.0, is_near ? a : 1) + margin;
    const double v_from = std::min(0.0, is_near ? b : 0) - margin,
                 v_to = std::max(1.0, is_near ? b : 1) + margin;
    // A little outside, or it would lie in the solid's own face.
    const glm::dvec3 corner = corners.at(i) + 0.004 * (corners.at(i) - corners.at(1 - i));
    const auto at = [&](double x, double y) { return corner + x * u + y * v; };
    planes.push_back(
        polygon(Role::edge, {at(u_from, v_from), at(u_to, v_from), at(u_to, v_to), at(u_from, v_to)}));
  }
  if (marks.size() == 2) planes.push_back(segment(Role::nearest, marks[0].points[0], marks[1].points[0]));
  append(planes, marks);
  return planes;
}

Binding slab_along(std::size_t axis) {
  const std::string name(1, "xyz"[axis]);
  return {name + "_in",
          [=](const NumbersByName& n) {
            const glm::dvec3 min = n.input("min"), max = n.input("max"), d = n.direction();
            std::array<glm::dvec3, 3> edges{};
            for (int i = 0; i < 3; ++i) edges.at(static_cast<std::size_t>(i))[i] = max[i] - min[i];
            // A ray parallel to some planes is there for those.
            const bool is_parallel = d.x == 0 || d.y == 0 || d.z == 0;
            if (is_parallel && d[static_cast<int>(axis)] != 0) return Items{};
            return slab(n, {min, min + edges.at(axis)}, edges.at((axis + 1) % 3), edges.at((axis + 2) % 3),
                        {name + "_in", name + "_out"});
          },
          true};
}

Binding slab_of_faces(const char* name, const char* edge, const char* u, const char* v) {
  return {name,
          [=](const NumbersByName& n) {
            const glm::dvec3 corner = n.vector("corner");
            return slab(n, {corner, corner + n.vector(edge)}, n.vector(u), n.vector(v), {"in", "out"});
          },
          true};
}

/// The stretch that all have in common, where there is one.
Items overlap(const NumbersByName& n) {
  if (!(n["t_entry"] < n["t_exit"])) return {};
  return {segment(Role::nearest, n.at(n["t_entry"]), n.at(n["t_exit"]), "inside")};
}

StageItem to_corner(const NumbersByName& n, const char* name) {
  return arrow(Role::edge, n.origin(), n.origin() + n.vector(name), name);
}

Items face_normals(const NumbersByName& n) {
  constexpr std::array<const char*, 3> names{"n₀", "n₁", "n₂"}, edges{"e₀", "e₁", "e₂"};
  Items items;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 u = n.vector(edges.at((i + 1) % 3)), v = n.vector(edges.at((i + 2) % 3));
    const glm::dvec3 middle = n.vector("corner") + 0.5 * (u + v);
    const double length = 0.5 * std::max(glm::length(u), glm::length(v));
    items.push_back(
        arrow(Role::normal, middle, middle + resized(n.vector(names.at(i)), length), names.at(i)));
  }
  return items;
}

Items ends(const NumbersByName& n) {
  return {level_ring(Role::edge, n["rx"], n["ry"], 0),  // the scene names it
          level_ring(Role::edge, n["rx"], n["ry"], n["height"], "z = height")};
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
      {"max - o",
       [](const NumbersByName& n) {
         return Items{to_corner(n, "min - o"), to_corner(n, "max - o")};
       }},
      slab_along(0),
      slab_along(1),
      slab_along(2),
      {"t_exit", overlap},
      {"t_entry", answer("t_entry").draw, true},
      answer("t_exit"),
  };
}

std::vector<Binding> parallelepiped_bindings() {
  return {
      {"n₂", face_normals},
      {"Meet each pair of faces", [](const NumbersByName& n) { return Items{to_corner(n, "f")}; }},
      slab_of_faces("n₀·f", "e₀", "e₁", "e₂"),
      slab_of_faces("n₁·f", "e₁", "e₂", "e₀"),
      slab_of_faces("n₂·f", "e₂", "e₀", "e₁"),
      {"t_exit", overlap},
      {"t_entry", answer("t_entry").draw, true},
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
