#pragma once
/// \file
/// Surfaces f(x, y, z) = 0 of any kind, and what a ray and one of them come to.
///
/// A surface is a callable of numbers of *any* arithmetic: `f(x, y, z)`, or, for a polynomial, its
/// homogeneous form `f(x, y, z, w)`, every term multiplied by the power of w that brings it to the full
/// degree, so that w = 1 is the surface and w = 0 its directions at infinity. With the second a ray without
/// end is searched to the end; see implicit/roots.hpp.

#include <cstddef>
#include <rayproof/method/contract.hpp>
#include <rayproof/ray.hpp>
#include <vector>

namespace rayproof {

/// What is known of the roots in an enclosure.
enum class RootStatus {
  certain,    ///< exactly one root, and f changes its sign there: the ray crosses the surface
  undecided,  ///< none, one or more roots: a tangent, a near miss, a root at an end of the ray's interval
  everywhere  ///< every t of the enclosure is a root: the ray lies in the surface
};

/// All t with lo <= t <= hi, and what is known of them. `hi` is infinite where no end is known.
template <class T>
struct RootEnclosure {
  T lo;
  T hi;
  RootStatus status;
};

/// Enclosures in ascending order. No two have a number in common but an end, and no t of the ray's interval
/// outside of them is a root.
template <class T>
using EnclosedRoots = std::vector<RootEnclosure<T>>;

/// The contract of `implicit::search` as far as it can be counted (its words stand with the function).
/// Measured: of the rays of docs/surfaces.md.
struct SearchContract {
  Bound missed;   ///< roots in the ray's interval that lie in no enclosure
  Bound wrong;    ///< certain enclosures that do not hold exactly one crossing
  Bound overrun;  ///< evaluations of f beyond twice the budget
};
inline constexpr SearchContract search_contract{.missed = {.measured = 0, .promised = 0},
                                                .wrong = {.measured = 0, .promised = 0},
                                                .overrun = {.measured = 129, .promised = 150}};

/// How often f may be evaluated for one ray, when nothing else is said. Few rays need a tenth of it
/// (docs/surfaces.md); what is left when it is spent comes back as undecided.
inline constexpr std::size_t default_budget = 4096;

/// A surface that comes with its homogeneous form.
template <class Surface, class T>
concept Homogeneous = requires(const Surface& f, const T& x) {
  f(x, x, x, x);
};

}  // namespace rayproof
