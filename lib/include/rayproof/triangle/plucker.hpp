#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/edge_function.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// On which side the ray passes each edge, by the Plücker side product: the volume of the direction and the
/// edge's two ends as seen from the origin, formed from the edge and the sum of its ends.
///
/// Two triangles that share an edge compute one number for it, with opposite signs, so no ray slips between
/// them, though rounding may put it on the wrong side.
struct Plucker {
  static constexpr const char* name = "plucker";
  static constexpr const char* title = "signs of the three Plücker sides";
  static constexpr Source source{"R. Jones", "Intersecting a Ray and a Triangle with Plücker Coordinates",
                                 2000};
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 2.99, .promised = triangle_divided_bound, .far_power = 1},
      .residual = {.measured = 2.44, .promised = triangle_robust_bound},
      .hit = triangle_hit_bounds,
      .holds = always_claimed | hit_claims |
               Claims{Claim::coordinates, Claim::verdict, Claim::residual, Claim::moved, Claim::scaled,
                      Claim::reversed, Claim::bounded, Claim::exact},
      .refuted = {{{Claim::robust, triangle_divisor_vanishes}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    step<T>(
        "Move the origin of the ray to the origin",
        "Seen from its origin the ray is only its direction d, so each edge needs only d and its two ends.");
    const vec3<T> a = named("a", triangle.a - ray.origin);
    const vec3<T> b = named("b", triangle.b - ray.origin);
    const vec3<T> c = named("c", triangle.c - ray.origin);
    const vec3<T> d = ray.direction;

    step<T>(
        "Find the side on which the ray passes each edge",
        "U, V and W are twice the volumes that d and the two ends of an edge span; the ray hits where no two "
        "have opposite signs and their sum is not 0.");
    // (p + q)×(q - p) = 2p×q, but with an edge in it: of a far triangle p and q nearly agree.
    const auto side = [&](const vec3<T>& p, const vec3<T>& q) { return dot(d, cross(p + q, q - p)); };
    const T U = named("U", side(b, c));
    const T V = named("V", side(c, a));
    const T W = named("W", side(a, b));

    step<T>("Meet the plane of the triangle",
            "t is n·a, |n| times the distance to the plane, over the progress n·d; U, V and W over their sum "
            "are the barycentric coordinates.");
    // By the edges, not as U + V + W: for a small far triangle those cancel.
    const vec3<T> n = named("n", cross(triangle.b - triangle.a, triangle.c - triangle.a));
    const T along = named("n·d", dot(n, d));
    const T t = named("t", dot(n, a) / along);
    const T sum = named("U+V+W", U + V + W);
    // Of a triangle so far and small that its ends are one point, all three vanish wherever the ray goes: a
    // miss, which is right unless the ray comes within a rounding of that point.
    return flat_hit(along != T(0) && sum != T(0) && same_side(U, V, W), t, named("u", V / sum),
                    named("v", W / sum));
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
