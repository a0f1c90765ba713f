#pragma once
/// \file
/// The quadratic equation ax² + bx + c = 0 and the meaning of its answers.

#include <array>
#include <cstddef>
#include <rayproof/roots.hpp>

namespace rayproof {

/// The coefficients of ax² + bx + c = 0.
///
/// Units of the contracts: *verdict* is the width of the band |b² - 4ac| <= k·ε·(b² + 4|ac|) in which the
/// kind of the roots may be wrong; *residual* is |ax² + bx + c| in units of ε·(|ax²| + |bx| + |c|), the
/// backward error of a root x; *ulp* is in ulps of the exact root. ε is the unit roundoff: 2^-24 in float,
/// 2^-53 in double. *Domain* speaks of the magnitudes of the nonzero coefficients.
template <class T>
struct Quadratic {
  T a, b, c;
};

/// The same equation in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Quadratic<To> convert(const Quadratic<From>& q) {
  return {To(q.a), To(q.b), To(q.c)};
}

/// How many real roots there are, and why; the names of the case format.
enum class RootKind { two, twice, none, linear, constant, everything };

/// A quadratic's answer: its kind, and its real roots ascending in `roots[0 .. count)`.
template <class T>
struct QuadraticAnswer {
  RootKind kind = RootKind::none;
  std::size_t count = 0;
  std::array<T, 2> roots{};
};

/// Reads a kernel's roots as an answer: a = 0 is decided by the coefficients, everything else by the sign
/// of the kernel's discriminant. In the linear case the kernel's one finite root is the answer, or the
/// infinity that both of its roots overflow to. Roots that are NaN are left out, whatever the kind.
template <class T>
[[nodiscard]] constexpr QuadraticAnswer<T> read(const Quadratic<T>& q, const Roots<T>& roots) {
  if (q.a == 0 && q.b == 0) return {q.c == 0 ? RootKind::everything : RootKind::constant};
  if (q.a == 0) {
    const bool is_lo = abs(roots.lo) < infinity<T> || roots.lo == roots.hi;
    const T root = is_lo ? roots.lo : roots.hi;
    return {RootKind::linear, is_lo || abs(root) < infinity<T> ? 1U : 0U, {root}};
  }
  const bool are_numbers = roots.lo == roots.lo && roots.hi == roots.hi;
  if (roots.discriminant > 0) return {RootKind::two, are_numbers ? 2U : 0U, {roots.lo, roots.hi}};
  if (roots.discriminant == 0) return {RootKind::twice, are_numbers ? 1U : 0U, {roots.lo}};
  return {RootKind::none};
}

/// The bound, in the units above, that a robust method for the quadratic keeps (Claim::robust).
inline constexpr double quadratic_robust_bound = 8;

}  // namespace rayproof
