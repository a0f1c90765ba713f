#include <algorithm>
#include <cmath>

#include "viz/walkthrough/bindings.hpp"

namespace rayproof::viz {
namespace {

struct Corners {
  glm::dvec3 a, b, c;
  [[nodiscard]] double size() const { return std::max(glm::length(b - a), glm::length(c - a)); }
  [[nodiscard]] glm::dvec3 normal() const { return glm::cross(b - a, c - a); }
};

/// As they were given: a kernel may call its own sheared corners by the same letters.
Corners corners_of(const NumbersByName& n) { return {n.input("a"), n.input("b"), n.input("c")}; }

Binding from_a(const char* name, Role role) {
  return {name, [=](const NumbersByName& n) {
            const Corners tri = corners_of(n);
            return Items{arrow(role, tri.a, tri.a + n.vector(name), name)};
          }};
}

/// An arrow that has a direction, but whose length is an area.
Binding direction_from_a(const char* name, Role role) {
  return {name, [=](const NumbersByName& n) {
            const Corners tri = corners_of(n);
            return Items{arrow(role, tri.a, tri.a + resized(n.vector(name), 0.8 * tri.size()), name)};
          }};
}

/// An edge of Cramer's system; elsewhere the first of two weights.
Items first_weight(const NumbersByName& n) {
  const Corners tri = corners_of(n);
  if (n.has_vector("u")) return {arrow(Role::edge, tri.a, tri.a + n.vector("u"), "u")};
  return {segment(Role::edge, tri.a, tri.a + n["u"] * (tri.b - tri.a), "u·e₁")};
}

Items second_weight(const NumbersByName& n) {
  const Corners tri = corners_of(n);
  if (n.has_vector("v")) return {arrow(Role::edge, tri.a, tri.a + n.vector("v"), "v")};
  const glm::dvec3 corner = tri.a + n["u"] * (tri.b - tri.a);
  return {segment(Role::edge, corner, corner + n["v"] * (tri.c - tri.a), "v·e₂")};
}

/// Cramer's α and β are lengths along the edges; elsewhere they are areas.
Items both_parameters(const NumbersByName& n) {
  return n.has_vector("u") ? parameters_from(n, corners_of(n).a) : Items{};
}

/// The other half of the parallelogram, where the sum of both parameters is more than 1.
Items other_half(const NumbersByName& n) {
  const Corners tri = corners_of(n);
  const glm::dvec3 far = tri.b + tri.c - tri.a;
  StageItem half = open_polygon(Role::edge, {tri.b, far, tri.c});
  half.label = "sum > 1";
  return {half, polyline(Role::edge, {tri.b, far, tri.c}, {}, Pattern::dashed)};
}

Items height_above_triangle(const NumbersByName& n) {
  const Corners tri = corners_of(n);
  return way_to_plane(n, tri.normal(), tri.a);
}

/// The shadow that the triangle and the hit cast along the axis where the normal is largest.
Items projection(const NumbersByName& n) {
  const Corners tri = corners_of(n);
  const glm::dvec3 normal = glm::abs(tri.normal());
  const int axis = normal.z >= normal.x && normal.z >= normal.y ? 2 : normal.y >= normal.x ? 1 : 0;
  const double floor = std::min({tri.a[axis], tri.b[axis], tri.c[axis]}) - 0.6 * tri.size();
  const auto drop = [&](glm::dvec3 p) {
    p[axis] = floor;
    return p;
  };
  const glm::dvec3 q = n.vector("q");
  Items items = outlined(Role::edge, {drop(tri.a), drop(tri.b), drop(tri.c)});
  for (const glm::dvec3& p : {tri.a, tri.b, tri.c, q})
    items.push_back(segment(Role::frame, p, drop(p), {}, Pattern::dotted));
  items.push_back(
      point(Role::nearest, drop(q), "q without " + std::string(1, static_cast<char>('x' + axis))));
  return items;
}

/// Möller and Trumbore's q is a direction across the other edge; elsewhere q is the point in the plane.
Items q_vector_or_point(const NumbersByName& n) {
  if (!n.has_vector("e₁")) return {point(Role::nearest, n.vector("q"), "q")};
  const Corners tri = corners_of(n);
  return {arrow(Role::normal, tri.a, tri.a + resized(n.vector("q"), 0.8 * tri.size()), "q")};
}

/// Which side of the ray each edge passes, as the kernel has it: the two and the ray span a volume.
Binding side(const char* name, int first, int second) {
  return {name, [=](const NumbersByName& n) {
            const Corners tri = corners_of(n);
            const glm::dvec3 all[] = {tri.a, tri.b, tri.c};
            return Items{segment(Role::edge, all[first], all[second], with_sign(name, n))};
          }};
}

}  // namespace

std::vector<Binding> triangle_bindings() {
  return {
      from_a("e₁", Role::edge),
      from_a("e₂", Role::edge),
      from_a("s", Role::nearest),
      from_a("w", Role::nearest),
      direction_from_a("p", Role::normal),
      {"q", q_vector_or_point},
      direction_from_a("n", Role::normal),
      direction_from_a("u×v", Role::normal),
      {"u", first_weight},
      {"v", second_weight},
      {"β", both_parameters},
      {"Ask whether the point lies in the triangle", other_half},
      {"Ask whether α and β lie in [0, 1], as printed", other_half},
      {"n·(p - o)", height_above_triangle},
      {"Project along the normal's largest axis", projection},
      {"Call z the axis along which the ray is longest", direction_arrow},
      side("U", 1, 2),
      side("V", 2, 0),
      side("W", 0, 1),
      answer("t"),
  };
}

}  // namespace rayproof::viz
