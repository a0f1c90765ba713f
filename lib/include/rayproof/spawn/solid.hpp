#pragma once
/// \file
/// Leaving a face of a box or a parallelepiped.

#include <rayproof/box.hpp>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/parallelepiped.hpp>
#include <rayproof/spawn/flat.hpp>

namespace rayproof::spawn {

/// Which of three is smallest; of equals the first.
template <class T>
struct SmallestOf {
  Mask<T> is_x, is_y;

  SmallestOf(const T& x, const T& y, const T& z) : is_x(x <= y && x <= z), is_y(y <= z) {}

  /// The one that belongs to the smallest.
  [[nodiscard]] T operator()(const T& of_x, const T& of_y, const T& of_z) const {
    return select(is_x, of_x, select(is_y, of_y, of_z));
  }
  [[nodiscard]] vec3<T> operator()(const vec3<T>& of_x, const vec3<T>& of_y, const vec3<T>& of_z) const {
    return select_vector<T>(is_x, of_x, select_vector<T>(is_y, of_y, of_z));
  }
};

/// The point moved straight onto the nearest face, where it is exact; and within the other faces by
/// `resolution`, so that what goes in near an edge is not outside the next face.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Box<T>& box, const vec3<T>& p,
                                                      const vec3<T>& resolution) {
  const vec3<T> to_low = magnitudes<T>(p - box.min), to_high = magnitudes<T>(box.max - p);
  const SmallestOf<T> face(min(to_low.x, to_high.x), min(to_low.y, to_high.y), min(to_low.z, to_high.z));
  const auto outward = [](const T& low, const T& high) { return select(high < low, T(1), T(-1)); };
  const auto onto = [](const T& side, const T& low, const T& high) { return select(T(0) < side, high, low); };
  const auto within = [](const T& at, const T& low, const T& high, const T& by) {
    return clamped(at, low + by, high - by);
  };
  const vec3<T> side{outward(to_low.x, to_high.x), outward(to_low.y, to_high.y),
                     outward(to_low.z, to_high.z)};
  const vec3<T> on{onto(side.x, box.min.x, box.max.x), onto(side.y, box.min.y, box.max.y),
                   onto(side.z, box.min.z, box.max.z)};
  const vec3<T> in{within(p.x, box.min.x, box.max.x, resolution.x),
                   within(p.y, box.min.y, box.max.y, resolution.y),
                   within(p.z, box.min.z, box.max.z, resolution.z)};
  const T zero(0);
  const vec3<T> nothing{zero, zero, zero};
  const vec3<T> normal =
      face(vec3<T>{side.x, zero, zero}, vec3<T>{zero, side.y, zero}, vec3<T>{zero, zero, side.z});
  const vec3<T> point = face(vec3<T>{on.x, in.y, in.z}, vec3<T>{in.x, on.y, in.z}, vec3<T>{in.x, in.y, on.z});
  return {p, point, normal, normal, nothing, zero, zero};
}

/// A parallelepiped as its three pairs of faces: unit normals that look from the corner, and how far the
/// faces of a pair are from one another along them.
template <class T>
struct Slanted {
  vec3<T> corner;
  vec3<T> edges[3];
  vec3<T> normals[3];
  T heights[3];
};

template <class To, class From>
[[nodiscard]] constexpr Slanted<To> convert(const Slanted<From>& from) {
  Slanted<To> to{convert<To>(from.corner), {}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    to.edges[i] = convert<To>(from.edges[i]);
    to.normals[i] = convert<To>(from.normals[i]);
    to.heights[i] = To(from.heights[i]);
  }
  return to;
}

template <std::floating_point T>
[[nodiscard]] Slanted<T> slanted(const Parallelepiped<T>& solid) {
  Slanted<T> made{solid.corner, {solid.edges[0], solid.edges[1], solid.edges[2]}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const vec3<T> n = cross_compensated<T>(made.edges[(i + 1) % 3], made.edges[(i + 2) % 3]);
    const T length = sqrt(dot(n, n)), height = dot_compensated<T>(n, made.edges[i]) / length;
    made.normals[i] = (height < 0 ? T(-1) : T(1)) / length * n;
    made.heights[i] = abs(height);
  }
  return made;
}

/// The point moved onto the nearest face's plane as a `Flat`, then along edges of that face within the other
/// faces. An upper face's plane goes through corner + edge, which is rounded by ε in each component; a normal
/// has 1.5 ulp from its cross product and 3ε from its length.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Slanted<T>& solid, const vec3<T>& p,
                                                      const vec3<T>& resolution) {
  constexpr auto eps = unit<T>;
  const vec3<T> f = p - solid.corner;
  T low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = abs(dot(solid.normals[i], f));
    high[i] = abs(dot(solid.normals[i], f - solid.edges[i]));
  }
  const SmallestOf<T> face(min(low[0], high[0]), min(low[1], high[1]), min(low[2], high[2]));
  const Mask<T> is_high = face(high[0], high[1], high[2]) < face(low[0], low[1], low[2]);
  const vec3<T> edge = face(solid.edges[0], solid.edges[1], solid.edges[2]);
  const vec3<T> upper = solid.corner + edge;
  const vec3<T> n = face(solid.normals[0], solid.normals[1], solid.normals[2]);
  const T sign = select(is_high, T(1), T(-1));
  const Flat<T> flat{select_vector<T>(is_high, upper, solid.corner), sign * n, T(9 * eps),
                     select(is_high, T(eps) * dot(magnitudes<T>(n), magnitudes<T>(upper)), T(0))};
  SurfacePoint<T> from = surface_point(flat, p, resolution);

  const T own[3] = {face(T(0), T(1), T(1)), face(T(1), T(0), T(1)), face(T(1), T(1), T(0))};
  const T least =
      sum<T>(resolution) + T(32 * eps) * (sum<T>(magnitudes<T>(f)) + sum<T>(magnitudes<T>(from.point)));
  for (int i = 0; i < 3; ++i) {
    const T depth = dot(solid.normals[i], from.point - solid.corner);
    const T wanted = clamped(depth, least, solid.heights[i] - least);
    const vec3<T> shift = (own[i] * ((wanted - depth) / solid.heights[i])) * solid.edges[i];
    from.point = from.point + shift;
    from.error =
        from.error + T(2 * eps) * magnitudes<T>(shift) + own[i] * (T(eps) * magnitudes<T>(from.point));
  }
  return from;
}

}  // namespace rayproof::spawn
