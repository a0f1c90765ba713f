#pragma once
/// \file
/// The unit normal of every figure at a point of its surface; the sphere's stands beside the sphere.

#include <rayproof/box.hpp>
#include <rayproof/cylinder.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/parallelepiped.hpp>
#include <rayproof/plane/forms.hpp>
#include <rayproof/sphere.hpp>
#include <rayproof/triangle.hpp>

namespace rayproof {

/// Along the given normal, or u × v.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Plane<T>& plane, const vec3<T>& /*anywhere*/) {
  return normalized<T>(plane::normal_of(plane));
}

/// Along (b-a)×(c-a).
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Triangle<T>& triangle, const vec3<T>& /*anywhere*/) {
  return normalized<T>(cross(triangle.b - triangle.a, triangle.c - triangle.a));
}

/// The Newell normal.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Polygon<T>& polygon, const vec3<T>& /*anywhere*/) {
  return normalized<T>(
      polygon::newell_normal<T>(polygon.vertices, polygon::nearest_the_origin(polygon.vertices)));
}

namespace detail {

/// Of three places between two faces each, 0 on the lower and 1 on the upper, the one nearest to a face:
/// its index, and on which side it is.
template <class T>
struct NearestFace {
  int pair = 0;
  bool is_upper = false;

  explicit NearestFace(const vec3<T>& place) {
    T nearest = T(infinity<T>);
    for (int i = 0; i < 3; ++i) {
      const T to_lower = abs(place[i]), to_upper = abs(T(1) - place[i]);
      if (!(min(to_lower, to_upper) < nearest)) continue;
      nearest = min(to_lower, to_upper);
      pair = i;
      is_upper = to_upper < to_lower;
    }
  }
};

}  // namespace detail

/// Outward, of the face nearest to the point.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Box<T>& box, const vec3<T>& point) {
  const detail::NearestFace<T> face((point - box.min) / (box.max - box.min));
  vec3<T> normal(0);
  normal[face.pair] = face.is_upper ? T(1) : T(-1);
  return normal;
}

/// Outward, of the face nearest to the point.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Parallelepiped<T>& solid, const vec3<T>& point) {
  const auto& e = solid.edges;
  const vec3<T> normals[3] = {cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])};
  const T volume = dot(e[0], normals[0]);
  const vec3<T> q = point - solid.corner;
  const detail::NearestFace<T> face(vec3<T>(dot(normals[0], q), dot(normals[1], q), dot(normals[2], q)) /
                                    volume);
  const T outward = face.is_upper == (volume > T(0)) ? T(1) : T(-1);
  return normalized<T>(outward * normals[face.pair]);
}

/// Outward, of the cap or the side, whichever is nearer.
template <std::floating_point T>
[[nodiscard]] vec3<T> normal_at(const Cylinder<T>& cylinder, const vec3<T>& point) {
  const T x = point.x / cylinder.rx, y = point.y / cylinder.ry;
  const T off_side = abs(T(1) - sqrt(x * x + y * y));
  const T off_bottom = abs(point.z), off_top = abs(cylinder.height - point.z);
  const T off_cap = min(off_bottom, off_top) / (cylinder.height > T(0) ? cylinder.height : T(1));
  if (cylinder.capped && off_cap < off_side) return {0, 0, off_top < off_bottom ? T(1) : T(-1)};
  return normalized<T>({x / cylinder.rx, y / cylinder.ry, T(0)});
}

}  // namespace rayproof
