#pragma once
/// \file
/// Surfaces r(u, v) over the unit square, and what a ray and one of them come to.
///
/// A surface is a callable of numbers of *any* arithmetic, `r(u, v)`, that gives a `Vec3` of them. One that
/// knows better bounds than interval arithmetic over its formula (a Bézier patch: the hull of its control
/// points) brings a `Piece`; see parametric/piece.hpp.

#include <cstddef>
#include <rayproof/arithmetics/dual.hpp>
#include <rayproof/method/contract.hpp>
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

/// The contract of `parametric::hits` as far as it can be counted (its words stand with the function).
/// Measured: of the patches of docs/surfaces.md.
struct HitsContract {
  Bound missed;    ///< hits that lie in the ranges of no answer
  Bound wrong;     ///< certain answers whose ranges do not hold exactly one hit
  Bound residual;  ///< |r(u, v) - p(t)| in units of the answer's own `residual`
};
inline constexpr HitsContract hits_contract{.missed = {.measured = 0, .promised = 0},
                                            .wrong = {.measured = 0, .promised = 0},
                                            .residual = {.measured = 0.52, .promised = 1}};

/// How many pieces of a patch are cut in two for one ray, when nothing else is said.
inline constexpr std::size_t default_pieces = 2048;

/// No piece narrower than this is cut. About the square root of ε: as fine as a tangent can be distinguished
/// from its neighbours.
template <class T>
inline constexpr T finest_piece = sizeof(T) == 4 ? T(0x1p-12) : T(0x1p-26);

}  // namespace rayproof
