#pragma once
/// \file
/// Leaving a face of a box or a parallelepiped.

#include <rayproof/box.hpp>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/parallelepiped.hpp>
#include <rayproof/spawn/dot_compensated.hpp>
#include <rayproof/spawn/flat.hpp>

#include <rayproof/rounding/as_written.hpp>

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

/// How far, along each axis, no point of the solid is from (0, 0, 0).
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Box<T>& box) {
  return magnitudes<T>(box.min) + magnitudes<T>(box.max);
}

/// A parallelepiped as its three pairs of faces: unit normals that look from the corner, and, for the pairs
/// in turn, how far its faces are from one another along them, one over that, and what that is off by.
template <class T>
struct Slanted {
  vec3<T> corner;
  vec3<T> edge_x, edge_y, edge_z;
  vec3<T> normal_x, normal_y, normal_z;
  vec3<T> height, per_height, height_error;
};

template <class To, class From>
[[nodiscard]] constexpr Slanted<To> convert(const Slanted<From>& from) {
  return {convert<To>(from.corner),      convert<To>(from.edge_x),   convert<To>(from.edge_y),
          convert<To>(from.edge_z),      convert<To>(from.normal_x), convert<To>(from.normal_y),
          convert<To>(from.normal_z),    convert<To>(from.height),   convert<To>(from.per_height),
          convert<To>(from.height_error)};
}

/// A normal has 1.5 ulp from its cross product and 4ε from its length; a height the same of each term.
template <std::floating_point T>
[[nodiscard]] Slanted<T> slanted(const Parallelepiped<T>& solid) {
  const auto& [x, y, z] = solid.edges;
  Slanted<T> made{solid.corner, x, y, z, {}, {}, {}, {}, {}, {}};
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

/// |edge_x| + |edge_y| + |edge_z|, component by component.
template <class T>
[[nodiscard]] constexpr vec3<T> edge_sizes(const Slanted<T>& solid) {
  return magnitudes<T>(solid.edge_x) + magnitudes<T>(solid.edge_y) + magnitudes<T>(solid.edge_z);
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
                  T(24 * eps) * (T(1) + shares) * sum<T>(edge_sizes(solid));
  const vec3<T> in{clamped(depth.x, least, height.x - least), clamped(depth.y, least, height.y - least),
                   clamped(depth.z, least, height.z - least)};
  const auto onto = [&](const T& whole) { return select(is_high, whole, zero); };
  const vec3<T> wanted = face(vec3<T>{onto(height.x), in.y, in.z}, vec3<T>{in.x, onto(height.y), in.z},
                              vec3<T>{in.x, in.y, onto(height.z)});
  const vec3<T> by = wanted - depth;
  const vec3<T> along_x = (by.x * solid.per_height.x) * solid.edge_x,
                along_y = (by.y * solid.per_height.y) * solid.edge_y,
                along_z = (by.z * solid.per_height.z) * solid.edge_z;
  const vec3<T> point = p + (along_x + along_y + along_z);

  const vec3<T> n = face(solid.normal_x, solid.normal_y, solid.normal_z), sizes = magnitudes<T>(n);
  const T move = abs(face(by.x, by.y, by.z));
  const T height_error = face(solid.height_error.x, solid.height_error.y, solid.height_error.z);
  const T share = move * face(solid.per_height.x, solid.per_height.y, solid.per_height.z);
  const T off = T(5 * eps) * dot(sizes, spread) + tilt * sum<T>(spread) + T(10 * eps) * move +
                height_error * (share + select(is_high, T(1), zero));
  const vec3<T> moved = magnitudes<T>(along_x) + magnitudes<T>(along_y) + magnitudes<T>(along_z);
  const vec3<T> error =
      off * sizes + T(eps) * (magnitudes<T>(point) + T(5) * moved) + (tilt * off) * vec3<T>{T(1), T(1), T(1)};
  const vec3<T> outward = select(is_high, T(1), T(-1)) * n;
  return {p, point, outward, outward, error, tilt, zero};
}

/// The same of a parallelepiped.
template <class T>
[[nodiscard]] constexpr vec3<T> outermost(const Slanted<T>& solid) {
  return magnitudes<T>(solid.corner) + edge_sizes(solid);
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
