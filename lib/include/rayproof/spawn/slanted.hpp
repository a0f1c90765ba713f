#pragma once
/// \file
/// Leaving a face of a parallelepiped.

#include <rayproof/parallelepiped.hpp>
#include <rayproof/spawn/dot_compensated.hpp>
#include <rayproof/spawn/solid.hpp>
#include <rayproof/transform.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// A parallelepiped as its three pairs of faces: unit normals that look from the corner, and, for the pairs
/// in turn, how far its faces are from one another along them, one over that, and what that is off by. The
/// edges' lengths are bounded once for all hits.
template <class T>
struct Slanted {
  vec3<T> corner;
  vec3<T> edge_x, edge_y, edge_z;
  vec3<T> normal_x, normal_y, normal_z;
  vec3<T> height, per_height, height_error;
  vec3<T> edge_sizes;    ///< |edge_x| + |edge_y| + |edge_z|, component by component
  vec3<T> edge_lengths;  ///< the largest component of each edge
};

template <class To, class From>
[[nodiscard]] constexpr Slanted<To> convert(const Slanted<From>& from) {
  return {convert<To>(from.corner),       convert<To>(from.edge_x),     convert<To>(from.edge_y),
          convert<To>(from.edge_z),       convert<To>(from.normal_x),   convert<To>(from.normal_y),
          convert<To>(from.normal_z),     convert<To>(from.height),     convert<To>(from.per_height),
          convert<To>(from.height_error), convert<To>(from.edge_sizes), convert<To>(from.edge_lengths)};
}

/// A normal has 1.5 ulp from its cross product and 4ε from its length; a height the same of each term.
template <std::floating_point T>
[[nodiscard]] Slanted<T> slanted(const Parallelepiped<T>& solid) {
  const auto& [x, y, z] = solid.edges;
  Slanted<T> made{solid.corner, x, y, z, {}, {}, {}, {}, {}, {}, {}, {}};
  made.edge_sizes = magnitudes<T>(x) + magnitudes<T>(y) + magnitudes<T>(z);
  const auto largest = [](const vec3<T>& v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); };
  made.edge_lengths = {largest(x), largest(y), largest(z)};
  const auto pair = [&](int i, vec3<T>& normal, const vec3<T>& edge, const vec3<T>& a, const vec3<T>& b) {
    const vec3<T> n = cross_compensated<T>(a, b);
    const T length = sqrt(dot(n, n)), height = dot_compensated<T>(n, edge) / length;
    normal = (height < 0 ? T(-1) : T(1)) / length * n;
    made.height[i] = abs(height);
    made.per_height[i] = T(1) / abs(height);
    made.height_error[i] = 8 * unit<T> * dot(magnitudes<T>(normal), magnitudes<T>(edge));
  };
  pair(0, made.normal_x, x, y, z);
  pair(1, made.normal_y, y, z, x);
  pair(2, made.normal_z, z, x, y);
  return made;
}

/// The point moved along the edges: along one onto the nearest face, along the others within the other faces.
///
/// An edge lies in the planes of the other pairs, so that each move changes the distance from its own pair
/// alone. That distance is off by 5ε·Σ|nᵢfᵢ| and tilt·|f|, and what is moved by 10ε of itself and the error
/// of the height, which also stands between a lower and an upper face.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Slanted<T>& solid, const vec3<T>& p,
                                                      const vec3<T>& resolution) {
  constexpr auto eps = unit<T>;
  const T zero(0), tilt(9 * eps);
  const vec3<T> f = p - solid.corner, spread = magnitudes<T>(f), &height = solid.height;
  const vec3<T> depth{dot(solid.normal_x, f), dot(solid.normal_y, f), dot(solid.normal_z, f)};
  const vec3<T> to_low = magnitudes<T>(depth), to_high = magnitudes<T>(height - depth);
  const SmallestOf<T> face(min(to_low.x, to_high.x), min(to_low.y, to_high.y), min(to_low.z, to_high.z));
  const Mask<T> is_high = face(to_high.x, to_high.y, to_high.z) < face(to_low.x, to_low.y, to_low.z);

  const T shares = dot(vec3<T>{min(to_low.x, to_high.x), min(to_low.y, to_high.y), min(to_low.z, to_high.z)},
                       solid.per_height);
  const T least = sum<T>(resolution) + T(32 * eps) * (sum<T>(spread) + sum<T>(magnitudes<T>(p))) +
                  T(24 * eps) * (T(1) + shares) * sum<T>(solid.edge_sizes);
  const vec3<T> in{clamped(depth.x, least, height.x - least), clamped(depth.y, least, height.y - least),
                   clamped(depth.z, least, height.z - least)};
  const auto onto = [&](const T& whole) { return select(is_high, whole, zero); };
  const vec3<T> wanted = face.replaced(in, vec3<T>{onto(height.x), onto(height.y), onto(height.z)});
  const vec3<T> by = wanted - depth;
  const vec3<T> part{by.x * solid.per_height.x, by.y * solid.per_height.y, by.z * solid.per_height.z};
  const vec3<T> point = p + (part.x * solid.edge_x + part.y * solid.edge_y + part.z * solid.edge_z);

  const vec3<T> n = face(solid.normal_x, solid.normal_y, solid.normal_z), sizes = magnitudes<T>(n);
  const T move = abs(face(by.x, by.y, by.z));
  const T height_error = face(solid.height_error.x, solid.height_error.y, solid.height_error.z);
  const T share = move * face(solid.per_height.x, solid.per_height.y, solid.per_height.z);
  const T off = T(5 * eps) * dot(sizes, spread) + tilt * sum<T>(spread) + T(10 * eps) * move +
                height_error * (share + select(is_high, T(1), zero));
  const T moved = dot(magnitudes<T>(part), solid.edge_lengths);  // no less than along any axis
  const vec3<T> error =
      off * sizes + T(eps) * magnitudes<T>(point) + same_along_each_axis<T>(T(5 * eps) * moved + tilt * off);
  const vec3<T> outward = select(is_high, T(1), T(-1)) * n;
  return {p, point, outward, outward, error, tilt, zero, true};
}

/// The same of a parallelepiped.
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Slanted<T>& solid, const vec3<T>& /*p*/) {
  return magnitudes<T>(solid.corner) + solid.edge_sizes;
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
