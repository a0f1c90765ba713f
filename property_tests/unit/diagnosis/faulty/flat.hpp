#pragma once
/// \file
/// Textbook planes, triangles and polygons, and points in polygons, with one fault each.

#include "unit/diagnosis/faulty/ray_code.hpp"

namespace rayproof::faulty {

/// normal·q + d = 0.
template <class T>
[[nodiscard]] FoundHits<T> find_plane(const Ray<T>& ray, const glm::vec<3, T>& normal, T d, Fault fault) {
  const T slope = dot(normal, ray.direction);
  const auto& o = ray.origin;
  if (fault == Fault::constant_sign) d = -d;
  if (fault == Fault::constant_ignored) d = 0;
  if (fault == Fault::unit_normal) d *= glm::length(normal);
  const T over = fault == Fault::no_coefficients ? o.x + o.y + o.z + d : dot(normal, o) + d;
  if (slope == 0) {
    if (fault == Fault::in_plane_hit && over == 0) return {{{0, normal}}};
    if (fault == Fault::parallel_hit) return {{{0, normal}}};
    const bool is_inside = (over == 0) != (fault == Fault::contacts_exchanged);
    return {{}, is_inside ? Contact::in_surface : Contact::parallel};
  }
  if (fault == Fault::one_sided && slope > 0) return {};
  if (fault == Fault::absolute_epsilon && std::abs(slope) < T(1e-6)) return {};
  return {{{-over / slope, normal}}};
}

template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const ImplicitPlane& plane, Fault fault) {
  return find_plane<T>(ray, glm::vec<3, T>(plane.normal), T(plane.d), fault);
}
template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const PointNormalPlane& plane, Fault fault) {
  const glm::vec<3, T> normal(plane.normal);
  return find_plane<T>(ray, normal, -dot(normal, glm::vec<3, T>(plane.point)), fault);
}
template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const ParametricPlane& plane, Fault fault) {
  const glm::vec<3, T> normal = cross(glm::vec<3, T>(plane.u), glm::vec<3, T>(plane.v));
  const double sides = glm::length(plane.u) * glm::length(plane.v);
  if (fault == Fault::skewed_missed && glm::length(normal) < T(0.1 * sides)) return {};
  return find_plane<T>(ray, normal, -dot(normal, glm::vec<3, T>(plane.point)), fault);
}

/// λ1 and λ2 in the projection along the normal's largest axis, or always along z.
template <class T>
[[nodiscard]] FoundHits<T> find_by_projection(const Ray<T>& ray, const Triangle<T>& triangle, Fault fault) {
  const auto n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const T slope = dot(n, ray.direction);
  if (slope == 0) return {};
  const T t = dot(n, triangle.a - ray.origin) / slope;
  const auto size = glm::abs(n);
  const int axis = fault == Fault::drops_z || (size.z >= size.x && size.z >= size.y) ? 2
                   : size.y >= size.x                                                ? 1
                                                                                     : 0;
  const auto flat = [&](const glm::vec<3, T>& p) { return Vec2<T>{p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
  const auto a = flat(triangle.a), b = flat(triangle.b), c = flat(triangle.c), q = flat(point_at(ray, t));
  const T D = (b.y - c.y) * (a.x - c.x) - (b.x - c.x) * (a.y - c.y);
  const T sign = fault == Fault::lambda_sign ? T(-1) : T(1);
  const T first = ((b.y - c.y) * (q.x - c.x) - (b.x - c.x) * (q.y - c.y)) / D;
  const T second = (-(a.y - c.y) * (q.x - c.x) + sign * (a.x - c.x) * (q.y - c.y)) / D;
  if (!(first >= 0 && second >= 0 && first + second <= 1)) return {};
  return {{{t, n, glm::dvec3(first, second, 1 - first - second)}}};
}

/// Möller–Trumbore.
template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const Triangle<T>& triangle, Fault fault) {
  if (fault == Fault::lambda_sign || fault == Fault::drops_z) return find_by_projection(ray, triangle, fault);
  const auto e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
  const auto p = cross(ray.direction, e2);
  const T det = dot(e1, p);
  if (fault == Fault::no_area_hit && cross(e1, e2) == glm::vec<3, T>(0)) return {{{T(0), p}}};
  if (fault == Fault::culls_back && det < 0) return {};
  if (det == 0 || (fault == Fault::absolute_epsilon && std::abs(det) < T(1e-2))) return {};
  const auto s = ray.origin - triangle.a, q = cross(s, e1);
  const T u = dot(s, p) / det, v = dot(ray.direction, q) / det, t = dot(e2, q) / det;
  bool is_inside = u >= 0 && v >= 0 && u + v <= 1;
  if (fault == Fault::no_sum_test) is_inside = u >= 0 && u <= 1 && v >= 0 && v <= 1;
  if (fault == Fault::no_beta_test) is_inside = v >= 0 && u + v <= 1;
  if (fault == Fault::no_test) is_inside = true;
  if (fault == Fault::edges_open) is_inside = u > 0 && v > 0 && u + v < 1;
  if (fault == Fault::one_edge_open) is_inside = u >= 0 && v >= 0 && u + v < 1;
  if (!is_inside) return {};
  return {{{t, cross(e1, e2), glm::dvec3(1 - u - v, u, v)}}};
}

/// Whether the point is in the polygon: an even number of crossings or not.
template <class T>
[[nodiscard]] bool is_inside(const Vec2<T>& p, const std::vector<Vec2<T>>& v, Fault fault) {
  const std::size_t all = fault == Fault::first_triangle ? 3 : v.size();
  int crossings = 0, windings = 0;
  bool left = false, right = false;
  const bool is_last_missing = fault == Fault::last_side_missing || fault == Fault::last_side_missing_above;
  for (std::size_t i = 0; i < all - (is_last_missing ? 1 : 0); ++i) {
    const auto &a = v[i], &b = v[(i + 1) % all];
    const T side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    left = left || side > 0;
    right = right || side < 0;
    if (a.y == b.y) continue;
    const bool lower = std::min(a.y, b.y) <= p.y, upper = p.y < std::max(a.y, b.y);
    bool is_level = lower && upper;
    if (fault == Fault::closed_sides) is_level = lower && p.y <= std::max(a.y, b.y);
    if (fault == Fault::last_side_missing_above)
      is_level = std::min(a.y, b.y) < p.y && p.y <= std::max(a.y, b.y);
    if (fault == Fault::open_sides) is_level = std::min(a.y, b.y) < p.y && upper;
    const bool is_right = b.y > a.y ? side >= 0 : side <= 0;  // the crossing lies at p.x or beyond
    if (!is_level || !is_right) continue;
    ++crossings;
    windings += b.y > a.y ? 1 : -1;
  }
  if (fault == Fault::convex_only) return !(left && right);
  return fault == Fault::winding ? windings != 0 : crossings % 2 == 1;
}

template <class T>
[[nodiscard]] FoundHits<T> find(const Ray<T>& ray, const Polygon<T>& polygon, Fault fault) {
  glm::vec<3, T> n{};
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) n += cross(v[i] - v[0], v[(i + 1) % v.size()] - v[0]);
  const T slope = dot(n, ray.direction);
  if (slope == 0 || (fault == Fault::culls_back && slope > 0)) return {};
  const T t = dot(n, v[0] - ray.origin) / slope;
  const auto size = glm::abs(n);
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  const auto flat = [&](const glm::vec<3, T>& p) { return Vec2<T>{p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
  std::vector<Vec2<T>> outline;
  for (const auto& vertex : v) outline.push_back(flat(vertex));
  if (!is_inside(flat(point_at(ray, t)), outline, fault)) return {};
  return {{{t, n}}};
}

}  // namespace rayproof::faulty
