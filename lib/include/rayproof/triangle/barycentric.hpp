#pragma once
/// \file
/// Barycentric coordinates of a point in a triangle: q = α·a + β·b + γ·c with α + β + γ = 1.

#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/plane/point_normal.hpp>
#include <rayproof/triangle.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// The hit at t with the parameters u and v of the triangle's plane, where they are those of a point of the
/// triangle; none where the determinant D, by which they were divided, is 0.
template <class T>
[[nodiscard]] constexpr FlatHit<T> hit_by_parameters(const T& D, const T& t, const T& u, const T& v) {
  step<T>("Ask whether the point lies in the triangle",
          "It does where D is not 0, both parameters are at least 0 and their sum is at most 1.");
  const Mask<T> is_inside = u >= T(0) && v >= T(0) && u + v <= T(1);
  return flat_hit(D != T(0) && is_inside, t, u, v);
}

/// Two edges that span the triangle's plane.
template <class T>
struct Edges {
  vec3<T> u, v;
};

template <class T>
[[nodiscard]] constexpr Edges<T> edges_from_a(const Triangle<T>& triangle) {
  step<T>(
      "Take the edges from a for u and v",
      "u leads from a to b. v leads from a to c: a + α·u + β·v is a point of the plane for every α and β.");
  return {named("u", vec3<T>(triangle.b - triangle.a)), named("v", vec3<T>(triangle.c - triangle.a))};
}

template <class T>
struct Barycentric {
  T alpha, beta, gamma;
};

/// α and β from the equations of x and y, γ = 1 - α - β. NaN or infinite, and never inside, where the
/// triangle has no area.
///
/// Source: P. Drábek, "Geometrie pro počítačovou grafiku", 2017.
template <class T>
[[nodiscard]] constexpr Barycentric<T> barycentric(const Vec2<T>& q, const Vec2<T>& a, const Vec2<T>& b,
                                                   const Vec2<T>& c) {
  const T area = named("D", (b.y - c.y) * (a.x - c.x) - (b.x - c.x) * (a.y - c.y));
  const T alpha = named("α", ((b.y - c.y) * (q.x - c.x) - (b.x - c.x) * (q.y - c.y)) / area);
  const T beta = named("β", ((a.x - c.x) * (q.y - c.y) - (a.y - c.y) * (q.x - c.x)) / area);
  return {alpha, beta, named("γ", T(1) - alpha - beta)};
}

/// A hit at t where the coordinates are those of a point of the closed triangle: none is negative or NaN.
template <class T>
[[nodiscard]] constexpr FlatHit<T> hit_inside(const T& t, const Barycentric<T>& w) {
  return flat_hit(w.alpha >= T(0) && w.beta >= T(0) && w.gamma >= T(0), t, w.beta, w.gamma);
}

/// Where a ray meets the plane of a triangle.
template <class T>
struct InPlane {
  T t;             ///< NaN where the ray is parallel to the plane
  vec3<T> point;   ///< p(t), rounded
  vec3<T> normal;  ///< (b-a)×(c-a)
};

template <class T>
[[nodiscard]] constexpr InPlane<T> meet_plane(const Ray<T>& ray, const Triangle<T>& triangle) {
  step<T>("Form the normal of the triangle",
          "n is perpendicular to both edges, and its length is twice the area.");
  const vec3<T> n = named("n", cross(triangle.b - triangle.a, triangle.c - triangle.a));
  const T t = plane::meet(ray, triangle.a, n).lo;
  return {t, named("q", point_at(ray, t)), n};
}

/// The ray's point in the triangle's plane and the triangle, projected along the axis where the triangle's
/// normal is largest, in which the triangle keeps the most of its area. The triangle may turn over in
/// projection; its coordinates stay.
template <class T>
struct Projected {
  T t;
  Vec2<T> q, a, b, c;
};

/// Source: R. Bán, "Számítógépes grafika: Raycasting", 2022.
template <class T>
[[nodiscard]] constexpr Projected<T> meet_and_project(const Ray<T>& ray, const Triangle<T>& triangle) {
  const auto [t, point, normal] = meet_plane(ray, triangle);
  step<T>(steps::project_along_largest_axis);
  const LargestAxisLast<T> turned(normal);
  return {t, turned.dropped(point), turned.dropped(triangle.a), turned.dropped(triangle.b),
          turned.dropped(triangle.c)};
}

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
