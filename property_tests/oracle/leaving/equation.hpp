#pragma once
/// \file
/// The equation f of a piece of surface at the origin of a ray, and its derivative along the ray, over a
/// ring: Interval and Estimate, which know when they can't decide, and the exact Ring.

#include "oracle/geometry/flat_equation.hpp"
#include "oracle/leaving/leaving.hpp"
#include "oracle/numbers/exact.hpp"
#include "oracle/numbers/filters.hpp"

namespace rayproof::oracle {

/// f and df/dt, both times the same number: an even power of the ray's scale, or an odd one.
template <class R>
struct PieceValue {
  R value, slope;
  bool is_odd = true;
};

/// Of a plane, seen from the ray.
template <class R>
[[nodiscard]] PieceValue<R> value_of_plane(const ObjectRay<R>& ray, const FlatEquation<R>& plane) {
  return {dot(plane.normal, ray.origin) - ray.scale * plane.offset, dot(plane.normal, ray.direction)};
}

template <class R>
[[nodiscard]] PieceValue<R> turned(const PieceValue<R>& value) {
  return {-value.value, -value.slope, value.is_odd};
}

template <class R, class Flat>
requires requires(const Flat& flat) { equation_of<R>(flat); }
[[nodiscard]] PieceValue<R> value_at(const ObjectRay<R>& ray, const Flat& flat, const SurfacePiece&) {
  return value_of_plane(ray, equation_of<R>(flat));
}

template <class R>
[[nodiscard]] PieceValue<R> value_at(const ObjectRay<R>& ray, const Sphere<double>& sphere,
                                     const SurfacePiece&) {
  const Vector<R> f = ray.origin - ray.scale * Vector<R>::from(sphere.center);
  const R radius = ray.scale * R(sphere.radius);
  return {dot(f, f) - radius * radius, dot(f, ray.direction), false};
}

template <class R>
[[nodiscard]] PieceValue<R> value_at(const ObjectRay<R>& ray, const Box<double>& box,
                                     const SurfacePiece& face) {
  const R bound(face.is_upper ? box.max[face.index] : box.min[face.index]);
  const PieceValue<R> value{ray.origin[face.index] - ray.scale * bound, ray.direction[face.index]};
  return face.is_upper ? value : turned(value);
}

/// The normal of a pair looks to the side of its own edge: a triple product that no filter must mistake, so
/// that its sign is the exact one.
template <class R>
[[nodiscard]] PieceValue<R> value_at(const ObjectRay<R>& ray, const Parallelepiped<double>& solid,
                                     const SurfacePiece& face) {
  const auto edge = [&]<class S>(int i, S) {
    return Vector<S>::from(solid.edges.at(static_cast<std::size_t>(i % 3)));
  };
  const auto volume = [&]<class S>(S zero) {
    return dot(edge(0, zero), cross(edge(1, zero), edge(2, zero)));
  };
  const auto filtered = certain_sign(volume(Interval()));
  const int handed = filtered ? *filtered : sign(volume(Ring(0.0)));
  const Vector<R> normal = cross(edge(face.index + 1, R(0.0)), edge(face.index + 2, R(0.0)));
  R offset = dot(normal, Vector<R>::from(solid.corner));
  if (face.is_upper) offset = offset + dot(normal, edge(face.index, R(0.0)));
  const PieceValue<R> value = value_of_plane<R>(ray, {normal, offset});
  return face.is_upper == (handed > 0) ? value : turned(value);
}

template <class R>
[[nodiscard]] PieceValue<R> value_at(const ObjectRay<R>& ray, const Cylinder<double>& cylinder,
                                     const SurfacePiece& piece) {
  if (piece.index == 1) {
    const PieceValue<R> value{ray.origin.z - ray.scale * R(piece.is_upper ? cylinder.height : 0.0),
                              ray.direction.z};
    return piece.is_upper ? value : turned(value);
  }
  const R rx(cylinder.rx), ry(cylinder.ry);
  const R x = ry * ray.origin.x, y = rx * ray.origin.y, radius = ray.scale * (rx * ry);
  return {x * x + y * y - radius * radius, x * (ry * ray.direction.x) + y * (rx * ray.direction.y), false};
}

/// Whether the judge knows the pieces of a shape; one that it does not know is never left.
template <class S>
inline constexpr bool has_pieces = requires(const ObjectRay<Ring>& ray, const S& shape,
                                            const SurfacePiece& piece) {
  value_at(ray, shape, piece);
};

}  // namespace rayproof::oracle
