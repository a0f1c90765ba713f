#pragma once
/// \file
/// The unit normal of every figure where a ray meets it, in its own space; the sphere's stands beside the
/// sphere.

#include <optional>
#include <rayproof/box.hpp>
#include <rayproof/cylinder.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/parallelepiped.hpp>
#include <rayproof/plane/forms.hpp>
#include <rayproof/sphere.hpp>
#include <rayproof/transform.hpp>
#include <rayproof/triangle.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Along the given normal, or u × v.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Plane<T>& plane, const vec3<T>& /*anywhere*/) {
  return unit_vector<T>(plane::normal_of(plane));
}

/// Along (b-a)×(c-a).
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Triangle<T>& triangle, const vec3<T>& /*anywhere*/) {
  return unit_vector<T>(cross(triangle.b - triangle.a, triangle.c - triangle.a));
}

/// The Newell normal.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Polygon<T>& polygon, const vec3<T>& /*anywhere*/) {
  return unit_vector<T>(
      polygon::newell_normal<T>(polygon.vertices, polygon::nearest_the_origin(polygon.vertices)));
}

/// Outward, of the face nearest to the point. Distances count in the rounding of each face, which grows with
/// the product of its edges' lengths: of a face thin as a needle the cross product is less than that.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Parallelepiped<T>& solid, const vec3<T>& point) {
  vec3<T> normal(0);
  T nearest = infinity<T>;
  for (std::size_t i = 0; i < 3; ++i) {
    const vec3<T>&e = solid.edges[i], &f = solid.edges[(i + 1) % 3], &g = solid.edges[(i + 2) % 3];
    const vec3<T> along = cross(f, g);
    const vec3<T> outward = dot(along, e) < T(0) ? -along : along;
    const vec3<T> q = point - solid.corner;
    const T size = sqrt(dot(f, f)) * sqrt(dot(g, g));
    for (const bool is_lower : {true, false}) {
      const T apart = abs(dot(along, is_lower ? q : q - e)) / size;
      if (!(apart < nearest)) continue;
      nearest = apart;
      normal = is_lower ? -outward : outward;
    }
  }
  return unit_vector<T>(normal);
}

/// Of any shape that has a normal at a point: there where the ray, in the shape's own space, is at t.
template <class Shape, std::floating_point T>
requires requires(const Shape& shape, const vec3<T>& point) { normal_at(shape, point); }
[[nodiscard]] vec3<T> normal_at(const Shape& shape, const Ray<T>& ray, const T& t) {
  return normal_at(shape, point_at(ray, t));
}

/// Outward, of the face whose own t is nearest to the hit's. Of two that are as near, as on an edge, the one
/// of the earlier axis; of one axis, the one that the ray enters by.
///
/// By t and not by the point: each t is off by the rounding of its own axis alone, while the point's
/// rounding, far from (0, 0, 0), is large beside a thin box.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Box<T>& box, const Ray<T>& ray, const T& t) {
  vec3<T> normal(0);
  T nearest = infinity<T>;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_entry : {true, false}) {
      const bool is_lower = (ray.direction[axis] > T(0)) == is_entry;
      const T own = ((is_lower ? box.min : box.max)[axis] - ray.origin[axis]) / ray.direction[axis];
      const T apart = abs(own - t);
      if (!(apart < nearest)) continue;  // also the NaN of a ray that is parallel to the face
      nearest = apart;
      normal = vec3<T>(0);
      normal[axis] = is_lower ? T(-1) : T(1);
    }
  return normal;
}

/// Outward, of the cap or the side, whichever is nearer. Distances count in the rounding that each has at t,
/// as in the units of the contracts: else the side of a flat cylinder, or the cap of a thin one, would seem
/// near. Where rounding leaves the point on the axis, it says nothing of the side, which then faces the ray.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Cylinder<T>& cylinder, const Ray<T>& ray, const T& t) {
  const auto scaled = [&](const vec3<T>& v) { return vec3<T>{v.x / cylinder.rx, v.y / cylinder.ry, v.z}; };
  const auto across = [](const vec3<T>& v) { return sqrt(v.x * v.x + v.y * v.y); };
  const vec3<T> p = scaled(point_at(ray, t)), origin = scaled(ray.origin), d = scaled(ray.direction);
  const vec3<T> run = t * d;
  const T off_side = abs(T(1) - across(p)) / (across(origin) + T(1) + across(run));
  const T to_bottom = abs(p.z), to_top = abs(cylinder.height - p.z);
  const T off_cap = min(to_bottom, to_top) / (abs(origin.z) + cylinder.height + abs(run.z));
  if (cylinder.capped && !(off_side <= off_cap)) return {0, 0, to_top < to_bottom ? T(1) : T(-1)};
  const vec3<T> outward = p.x == T(0) && p.y == T(0) ? -d : p;
  return unit_vector<T>({outward.x / cylinder.rx, outward.y / cylinder.ry, T(0)});
}

/// Outward, of the face nearest to the point: of a box under a map. A ray that was rounded on its way into
/// the box's space is off by as much along each axis, and of a face that it nearly runs along t says little.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_of_nearest_face(const Box<T>& box, const vec3<T>& point) {
  vec3<T> normal(0);
  T nearest = infinity<T>;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_lower : {true, false}) {
      const T apart = abs((is_lower ? box.min : box.max)[axis] - point[axis]);
      if (!(apart < nearest)) continue;
      nearest = apart;
      normal = vec3<T>(0);
      normal[axis] = is_lower ? T(-1) : T(1);
    }
  return normal;
}

/// The normal in the world where the world's ray is at t: of an object that is put there by a map, or of a
/// shape as it is.
template <class Shape, std::floating_point T>
[[nodiscard]] vec3<T> normal_in_world(const std::optional<ObjectSpace<T>>& space, const Shape& shape,
                                      const Ray<T>& ray, const T& t) {
  if (!space) return normal_at(shape, ray, t);
  const Ray<T> own_ray = to_object(*space, ray);
  if constexpr (std::is_same_v<Shape, Box<T>>)
    return normal_to_world(*space, normal_of_nearest_face(shape, point_at(own_ray, t)));
  else
    return normal_to_world(*space, normal_at(shape, own_ray, t));
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
