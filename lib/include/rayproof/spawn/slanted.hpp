#pragma once
/// \file
/// Leaving a face of a parallelepiped.

#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/parallelepiped.hpp>
#include <rayproof/spawn/long_sum.hpp>
#include <rayproof/spawn/placement.hpp>
#include <rayproof/spawn/solid.hpp>
#include <rayproof/transform.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// A parallelepiped as its three pairs of faces: unit normals that look from the corner, and, for the pairs
/// in turn, how far its faces are from one another along them, one over that, half of it, and what it is off
/// by. Corner and edges may be off by 2ε of themselves. Made once for all hits.
template <class T>
struct Slanted {
  vec3<T> corner;
  vec3<T> edge_x, edge_y, edge_z;
  vec3<T> normal_x, normal_y, normal_z;
  vec3<T> height, per_height, half_height, height_error;
  vec3<T> corner_error;
  vec3<T> edge_lengths;  ///< the largest component of each edge
  T edge_sum;            ///< the sum of the magnitudes of all their components
};

template <class To, class From>
[[nodiscard]] constexpr Slanted<To> convert(const Slanted<From>& from) {
  return {convert<To>(from.corner),       convert<To>(from.edge_x),
          convert<To>(from.edge_y),       convert<To>(from.edge_z),
          convert<To>(from.normal_x),     convert<To>(from.normal_y),
          convert<To>(from.normal_z),     convert<To>(from.height),
          convert<To>(from.per_height),   convert<To>(from.half_height),
          convert<To>(from.height_error), convert<To>(from.corner_error),
          convert<To>(from.edge_lengths), To(from.edge_sum)};
}

namespace detail {

/// With these edges; the rest is filled in by whoever knows the faces.
template <std::floating_point T>
[[nodiscard]] Slanted<T> slanted_along(const vec3<T>& corner, const vec3<T>& x, const vec3<T>& y,
                                       const vec3<T>& z) {
  const auto largest = [](const vec3<T>& v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); };
  const T edge_sum = sum<T>(magnitudes<T>(x) + magnitudes<T>(y) + magnitudes<T>(z));
  return {corner, x, y, z, {}, {}, {}, {}, {}, {}, {}, {}, {largest(x), largest(y), largest(z)}, edge_sum};
}

/// The pair of faces number i, this far from one another.
template <std::floating_point T>
void set_height(Slanted<T>& made, int i, T height, T error) {
  made.height[i] = height;
  made.per_height[i] = T(1) / height;
  made.half_height[i] = T(0.5) * height;
  made.height_error[i] = error;
}

}  // namespace detail

/// A normal has 1.5 ulp from its cross product and 4ε from its length; a height the same of each term.
template <std::floating_point T>
[[nodiscard]] Slanted<T> slanted(const Parallelepiped<T>& solid) {
  const auto& [x, y, z] = solid.edges;
  Slanted<T> made = detail::slanted_along<T>(solid.corner, x, y, z);
  const auto pair = [&](int i, vec3<T>& normal, const vec3<T>& edge, const vec3<T>& a, const vec3<T>& b) {
    const vec3<T> n = cross_compensated<T>(a, b);
    const T length = sqrt(dot(n, n)), height = detail::dot_compensated<T>(n, edge) / length;
    normal = (height < 0 ? T(-1) : T(1)) / length * n;
    detail::set_height<T>(made, i, abs(height),
                          8 * unit<T> * dot(magnitudes<T>(normal), magnitudes<T>(edge)));
  };
  pair(0, made.normal_x, x, y, z);
  pair(1, made.normal_y, y, z, x);
  pair(2, made.normal_z, z, x, y);
  return made;
}

/// The image of a parallelepiped with exact corner and edges under a map: a parallelepiped again, left in the
/// world as any other. Its corner, edges and normals are computed exactly and rounded once, so that they are
/// as good as an untransformed one's however badly the map is conditioned: an edge is off by 2ε of itself, a
/// normal by 6ε, a height by 6ε of itself.
template <std::floating_point T>
[[nodiscard]] Slanted<T> place(const Slanted<T>& solid, const Placement<T>& map) {
  using Exact = GrowingExpansion<double>;
  using Vector = Vec3<Exact>;
  const auto exact = [](const vec3<T>& v) { return rayproof::convert<Exact>(v); };
  const Vector column_x = exact(map.column_x), column_y = exact(map.column_y), column_z = exact(map.column_z);
  const auto image = [&](const vec3<T>& v) {
    return Exact(v.x) * column_x + Exact(v.y) * column_y + Exact(v.z) * column_z;
  };
  const auto nearest = [](const Exact& x) { return estimate(compressed<24>(x)); };
  const auto wide = [&](const Vector& v) { return glm::dvec3{nearest(v.x), nearest(v.y), nearest(v.z)}; };
  const auto rounded = [&](const Vector& v) { return convert<T>(wide(v)); };
  const Vector x = image(solid.edge_x), y = image(solid.edge_y), z = image(solid.edge_z);
  const vec3<T> corner = rounded(image(solid.corner) + exact(map.inverse.translation));

  Slanted<T> made = detail::slanted_along<T>(corner, rounded(x), rounded(y), rounded(z));
  made.corner_error = T(2 * unit<T>) * magnitudes<T>(corner);
  const auto pair = [&](int i, vec3<T>& normal, const Vector& edge, const Vector& a, const Vector& b) {
    const Vector n = cross(a, b);
    const glm::dvec3 along = wide(n);
    const double length = sqrt(dot(along, along)), height = nearest(dot(n, edge)) / length;
    normal = convert<T>((height < 0 ? -1 : 1) / length * along);
    detail::set_height<T>(made, i, static_cast<T>(abs(height)), static_cast<T>(8 * unit<T> * abs(height)));
  };
  pair(0, made.normal_x, x, y, z);
  pair(1, made.normal_y, y, z, x);
  pair(2, made.normal_z, z, x, y);
  return made;
}

/// How far the point is above the lower face of each pair.
template <class T>
[[nodiscard]] constexpr vec3<T> depth_in(const Slanted<T>& solid, const vec3<T>& p) {
  const vec3<T> f = p - solid.corner;
  return {dot(solid.normal_x, f), dot(solid.normal_y, f), dot(solid.normal_z, f)};
}

/// The point moved along each edge by such a part of it.
template <class T>
[[nodiscard]] constexpr vec3<T> moved_along_edges(const Slanted<T>& solid, const vec3<T>& p,
                                                  const vec3<T>& part) {
  return p + (part.x * solid.edge_x + part.y * solid.edge_y + part.z * solid.edge_z);
}

/// The hit itself, unless it lies beside the solid by more than the solid is thick, as one that is seen from
/// far away may: then it is moved along the edges to about the solid. What is moved by many edges at once is
/// rounded by as much of them, which may be more than the solid is thick.
template <class T>
[[nodiscard]] constexpr vec3<T> brought_near(const Slanted<T>& solid, const vec3<T>& p) {
  const T zero(0), one(1);
  const vec3<T> depth = depth_in(solid, p);
  const auto part = [&](const T& at, const T& whole, const T& per_whole) {
    return (clamped(at, zero, whole) - at) * per_whole;
  };
  const vec3<T> parts{part(depth.x, solid.height.x, solid.per_height.x),
                      part(depth.y, solid.height.y, solid.per_height.y),
                      part(depth.z, solid.height.z, solid.per_height.z)};
  const Mask<T> is_near = abs(parts.x) <= one && abs(parts.y) <= one && abs(parts.z) <= one;
  if (in_all_lanes(is_near)) return p;
  return select_vector<T>(is_near, p, moved_along_edges(solid, p, parts));
}

/// The point moved along the edges: along one onto the nearest face, along the others within the other faces.
///
/// An edge lies in the planes of the other pairs, so that each move changes the distance from its own pair
/// alone. That distance is off by 5ε·Σ|nᵢfᵢ| and tilt·|f|, and what is moved by 10ε of itself and the error
/// of the height, which also stands between a lower and an upper face. What is moved is rounded by 5ε, and
/// the edge by 2ε more.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> surface_point(const Slanted<T>& solid, const vec3<T>& hit,
                                                      const vec3<T>& resolution) {
  constexpr auto eps = unit<T>;
  const T zero(0), tilt(9 * eps);
  const vec3<T> p = brought_near(solid, hit), depth = depth_in(solid, p), &height = solid.height;
  const vec3<T> spread = magnitudes<T>(p - solid.corner);
  const vec3<T> to_low = magnitudes<T>(depth), to_high = magnitudes<T>(height - depth);
  const vec3<T> to_face{min(to_low.x, to_high.x), min(to_low.y, to_high.y), min(to_low.z, to_high.z)};
  const SmallestOf<T> face(to_face.x, to_face.y, to_face.z);
  const T move = face(to_face.x, to_face.y, to_face.z);
  const Mask<T> is_low = face(to_low.x, to_low.y, to_low.z) <= move;

  const T least = sum<T>(resolution) + T(36 * eps) * (sum<T>(spread) + sum<T>(magnitudes<T>(p))) +
                  T(28 * eps) * solid.edge_sum * (T(1) + dot(to_face, solid.per_height));
  const auto within = [&](const T& at, const T& whole, const T& half) {
    const T margin = min(least, half);
    return min(max(at, margin), whole - margin);
  };
  const vec3<T> in{within(depth.x, height.x, solid.half_height.x),
                   within(depth.y, height.y, solid.half_height.y),
                   within(depth.z, height.z, solid.half_height.z)};
  const auto onto = [&](const T& whole) { return select(is_low, zero, whole); };
  const vec3<T> wanted = face.replaced(in, vec3<T>{onto(height.x), onto(height.y), onto(height.z)});
  const vec3<T> by = wanted - depth;
  const vec3<T> part{by.x * solid.per_height.x, by.y * solid.per_height.y, by.z * solid.per_height.z};
  const vec3<T> point = moved_along_edges(solid, p, part);

  const vec3<T> n = face(solid.normal_x, solid.normal_y, solid.normal_z), sizes = magnitudes<T>(n);
  const vec3<T> shares = magnitudes<T>(part);
  const T height_error = face(solid.height_error.x, solid.height_error.y, solid.height_error.z);
  const T off = T(5 * eps) * dot(sizes, spread) + tilt * sum<T>(spread) + T(10 * eps) * move +
                height_error * (face(shares.x, shares.y, shares.z) + select(is_low, zero, T(1)));
  const T moved = dot(shares, solid.edge_lengths);  // no less than along any axis
  const vec3<T> error = off * sizes + T(eps) * magnitudes<T>(point) +
                        (solid.corner_error + same_along_each_axis<T>(T(7 * eps) * moved + tilt * off));
  const vec3<T> outward = select(is_low, T(-1), T(1)) * n;
  return {hit, point, outward, outward, error, tilt, zero, true};
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
