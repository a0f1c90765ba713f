#pragma once
/// \file
/// Surfaces r(u, v) over the unit square, and what a ray and one of them come to.
///
/// A surface is a callable of numbers of *any* arithmetic, `r(u, v)`, that gives a `Vec3` of them. One that
/// knows better bounds than interval arithmetic over its formula (a Bézier patch: the hull of its control
/// points) brings a `Piece`; see parametric/piece.hpp.

#include <cstddef>
#include <rayproof/arithmetics/dual.hpp>
#include <rayproof/ray.hpp>
#include <vector>

namespace rayproof {

/// One hit: p(t) = r(u, v).
template <class T>
struct PatchHit {
  T t, u, v;        ///< plain numbers inside of the ranges below
  T residual;       ///< |r(u, v) - p(t)| is not larger than this, rounding included
  bool is_certain;  ///< there is exactly one hit in the ranges; otherwise none, one or more
  Interval<T> t_range, u_range, v_range;
};

/// Ascending by t. Every hit of the ray's interval with the closed unit square lies in the ranges of one of
/// them.
template <class T>
using PatchHits = std::vector<PatchHit<T>>;

/// How many pieces of a patch are looked at for one ray, when nothing else is said.
inline constexpr std::size_t default_pieces = 2048;

}  // namespace rayproof
