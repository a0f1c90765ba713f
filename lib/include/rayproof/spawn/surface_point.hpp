#pragma once
/// \file
/// A point of a surface as rounded arithmetic knows it, from which the next ray is to start: how far the
/// exact surface may be from it, and how wrong its normal.

#include <rayproof/arithmetic.hpp>
#include <rayproof/spawn/side.hpp>
#include <rayproof/vec3.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

using rayproof::convert;

/// ε, the unit roundoff of the arithmetic: 2^-24 in float, 2^-53 in double.
template <class T>
inline constexpr Plain<T> unit = std::numeric_limits<Plain<T>>::epsilon() / 2;

/// More than underflow can take from any length here, and less than any length that matters: 2^-100 in float,
/// 2^-900 in double, for scenes whose lengths stay within 2^±28 and 2^±240.
template <class T>
inline constexpr Plain<T> least_offset = sizeof(Plain<T>) == 4 ? Plain<T>(0x1p-100) : Plain<T>(0x1p-900);

/// Where a ray has met a surface and the next one leaves it.
///
/// `hit` is p(t), as the ray's own numbers give it. `point` is the same moved onto the surface: some point s
/// of the exact surface has |point - s| <= `error` in each component. N is the exact unit normal at s, on the
/// side to which the next ray goes.
///
/// What is bounded, in lengths of the space the point is in:
///  - |normal - N| <= `tilt`;
///  - `bend` bounds the curvature: there is an affine map that makes the surface a sphere, stretches no
///    length by more than g and lengths along N by h, and bend >= g²/(h·radius) in the map's lengths; 0 for
///    what is flat;
///  - N·`radial` = 1, and what the map makes of `radial` looks away from the sphere's centre.
template <class T>
struct SurfacePoint {
  vec3<T> hit;
  vec3<T> point;
  vec3<T> normal;
  vec3<T> radial;
  vec3<T> error;
  T tilt;
  T bend;
  bool is_flat = false;  ///< `bend` is 0 of the whole surface, and need not be computed with
};

/// Turns the normal to the back where `side` is negative, to the front elsewhere. In place: g++ 12 copies a
/// struct of packs in halves, which takes longer than all that is computed of it.
template <class T>
constexpr void turn(SurfacePoint<T>& from, const T& side) {
  const T sign = copysign(T(1), side);
  from.normal = sign * from.normal;
  from.radial = sign * from.radial;
}
/// The point for a ray that leaves to this side. A program knows the side, for it knows whether it reflects
/// or refracts; the sign of a rounded normal·direction need not be the exact one where the ray grazes.
template <class T>
[[nodiscard]] constexpr SurfacePoint<T> towards(Side side, SurfacePoint<T> from) {
  turn(from, T(side == Side::front ? 1 : -1));
  return from;
}

/// Makes a normal of any length one of unit length, and with it `radial`, which is given for that length, and
/// `bend`, which is given for length 1; returns one over the length.
template <class T>
constexpr T make_unit(SurfacePoint<T>& from) {
  const T length = sqrt(dot(from.normal, from.normal)), per_length = T(1) / length;
  from.normal = per_length * from.normal;
  from.radial = length * from.radial;
  from.bend = per_length * from.bend;
  return per_length;
}

/// |v|, component by component.
template <class T>
[[nodiscard]] constexpr vec3<T> magnitudes(const vec3<T>& v) {
  return vec3<T>{abs(v.x), abs(v.y), abs(v.z)};
}

/// (x, x, x).
template <class T>
[[nodiscard]] constexpr vec3<T> same_along_each_axis(const T& x) {
  return vec3<T>{x, x, x};
}

/// Whether a mask, a bool or a pack's, holds in every lane, so that what no lane asks for need not be
/// computed; of other arithmetics' masks it is not known.
template <class M>
[[nodiscard]] constexpr bool in_all_lanes(const M& mask) {
  if constexpr (std::is_same_v<M, bool>) {
    return mask;
  } else if constexpr (requires { all_of(mask); }) {
    return all_of(mask);
  } else {
    return false;
  }
}

/// x + y + z.
template <class T>
[[nodiscard]] constexpr T sum(const vec3<T>& v) {
  return v.x + v.y + v.z;
}

/// `x` between `low` and `high`; their middle where they stand the wrong way round.
template <class T>
[[nodiscard]] constexpr T clamped(const T& x, const T& low, const T& high) {
  return select(high < low, T(0.5) * (low + high), min(max(x, low), high));
}

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
