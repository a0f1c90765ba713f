#pragma once
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/edge_function.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// The scene sheared so that the ray is the z axis, then the three edge functions of the origin
/// with their exact signs: watertight.
///
/// A vertex is sheared alike for all its triangles and an edge function has the sign of its exact value, so
/// no ray passes between two triangles that share an edge or all around a vertex that they share. Departs
/// from its source in that edge functions need no second try in double, that z is not scaled before t is
/// found, and that no axes are swapped to keep the winding: either side counts.
struct Woop {
  static constexpr const char* name = "woop";
  static constexpr const char* title = "watertight: sheared to the ray, exact edge functions";
  static constexpr Source source{"S. Woop, C. Benthin, I. Wald", "Watertight Ray/Triangle Intersection",
                                 2013};
  static constexpr Contract contract{
      .verdict = {.measured = 2.81, .promised = triangle_robust_bound},
      .residual = {.measured = 2.23, .promised = triangle_robust_bound},
      .hit = triangle_hit_bounds,
      .holds = robust_claims | hit_claims | Claims{Claim::coordinates, Claim::residual, Claim::bounded}};

  static constexpr Step shear_vertices{"Shear the vertices so that the ray becomes the z axis",
                                       "Each vertex has o subtracted, its axes renamed, and S_x·z and S_y·z "
                                       "taken from x and y. Now the ray is the z axis; seen along it, it is "
                                       "the point (0, 0)."};
  static constexpr Step find_sides{
      "Find the side on which the ray passes each edge",
      "The sign of U, V and W is exact where no product underflows: it says on "
      "which side of an edge (0, 0) lies. The ray hits where no two of them have "
      "opposite signs and D is not 0."};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    step<T>(
        "Call z the axis along which the ray is longest",
        "The axes are renamed in turn, x, y, z as y, z, x or z, x, y, until d = {d} is longest along z. The "
        "shear divides by d.z, so S_x and S_y are at most 1 in size.");
    const LargestAxisLast<T> turned(ray.direction);
    const vec3<T> d = named("d", turned(ray.direction));
    const T shear_x = named("S_x", d.x / d.z);
    const T shear_y = named("S_y", d.y / d.z);

    step<T>(shear_vertices);
    const auto sheared = [&](const vec3<T>& vertex) {
      const vec3<T> w = turned(vertex - ray.origin);
      return vec3<T>{w.x - shear_x * w.z, w.y - shear_y * w.z, w.z};
    };
    const vec3<T> a = named("a", sheared(triangle.a));
    const vec3<T> b = named("b", sheared(triangle.b));
    const vec3<T> c = named("c", sheared(triangle.c));

    step<T>(find_sides);
    const T U = named("U", edge_function(c.x, b.y, c.y, b.x));
    const T V = named("V", edge_function(a.x, c.y, a.y, c.x));
    const T W = named("W", edge_function(b.x, a.y, b.y, a.x));
    const T D = named("D", U + V + W);

    step<T>("Weigh the depths of the vertices",
            "U, V and W over their sum D are the weights of the vertices; the hit's depth z is the weighted "
            "mean, and t = z / d.z.");
    const T u = named("u", V / D);
    const T v = named("v", W / D);
    const T z = named("z", (U * a.z + V * b.z + W * c.z) / D);
    return flat_hit(D != T(0) && same_side(U, V, W), named("t", z / d.z), u, v);
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
