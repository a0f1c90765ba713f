#pragma once
/// \file
/// Whole vectors, and the whole points of a plane: where to look for a case that is hard by a hair.

#include <boost/multiprecision/cpp_int.hpp>

#include "generators/scene.hpp"

namespace rayproof::lattice {

using Whole = boost::multiprecision::int512_t;
using WholeVector = std::array<Whole, 3>;

[[nodiscard]] inline Whole dot(const WholeVector& a, const WholeVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] inline WholeVector cross(const WholeVector& a, const WholeVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// a + k·b.
[[nodiscard]] inline WholeVector plus(const WholeVector& a, const Whole& k, const WholeVector& b) {
  return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}

/// In steps of 2^-bits; what is less than a step is left out.
[[nodiscard]] inline Whole whole(double x, int bits) {
  int exponent = 0;
  const Whole digits(std::llround(std::ldexp(std::frexp(x, &exponent), 53)));
  const int more = bits + exponent - 53;
  return more < 0 ? digits / (Whole(1) << -more) : digits << more;
}
[[nodiscard]] inline WholeVector whole(const glm::dvec3& v, int bits) {
  return {whole(v.x, bits), whole(v.y, bits), whole(v.z, bits)};
}
[[nodiscard]] inline double number(const Whole& steps, int bits) {
  return std::ldexp(steps.convert_to<double>(), -bits);
}
[[nodiscard]] inline glm::dvec3 vector(const WholeVector& v, int bits) {
  return {number(v[0], bits), number(v[1], bits), number(v[2], bits)};
}
/// A number that has up to twice the digits of a precision, as the difference of two that it has.
struct Difference {
  double high, low;
};
[[nodiscard]] inline Difference difference(Precision precision, const Whole& steps, int bits) {
  const double high = round_to(precision, number(steps, bits));
  return {high, round_to(precision, number(whole(high, bits) - steps, bits))};
}
/// A number, vector or shape to multiples of 2^-bits.
template <class V>
[[nodiscard]] V on_grid(V x, int bits) {
  each_number(x, [bits](double& each) { each = std::ldexp(std::round(std::ldexp(each, bits)), -bits); });
  return x;
}

/// Without its components' common factor; the zero vector stays.
[[nodiscard]] inline WholeVector primitive(const WholeVector& v) {
  const Whole factor = gcd(gcd(v[0], v[1]), v[2]);
  return factor == 0 ? v : WholeVector{v[0] / factor, v[1] / factor, v[2] / factor};
}
/// a / b to the nearest whole number, for b > 0.
[[nodiscard]] inline Whole nearest(const Whole& a, const Whole& b) {
  return a < 0 ? -((b - 2 * a) / (2 * b)) : (b + 2 * a) / (2 * b);
}

/// x and y with a·x + b·y = gcd(a, b), by Euclid's algorithm.
struct Bezout {
  Whole gcd, x, y;
};
[[nodiscard]] inline Bezout bezout(const Whole& a, const Whole& b) {
  Bezout now{a, 1, 0}, next{b, 0, 1};
  while (next.gcd != 0) {
    const Whole times = now.gcd / next.gcd;
    now = {now.gcd - times * next.gcd, now.x - times * next.x, now.y - times * next.y};
    std::swap(now, next);
  }
  return now.gcd < 0 ? Bezout{-now.gcd, -now.x, -now.y} : now;
}
/// a·x modulo m is r, for a without a factor in common with m.
[[nodiscard]] inline Whole quotient_modulo(const Whole& r, const Whole& a, const Whole& m) {
  const Whole x = r * bezout(a, m).x % m;
  return x < 0 ? x + m : x;
}

/// The whole points of the planes n·x = value, for n without a common factor. Two short vectors span them, by
/// J. L. Lagrange's reduction (1773), and `unit`, with n·unit = 1, leads from one plane to the next.
struct PlaneLattice {
  WholeVector normal, first, second, unit;

  explicit PlaneLattice(const WholeVector& n) : normal(n) {
    const auto [g, x, y] = bezout(n[0], n[1]);
    const auto [one, u, w] = bezout(g, n[2]);
    first = g == 0 ? WholeVector{1, 0, 0} : WholeVector{n[1] / g, -n[0] / g, 0};
    second = g == 0 ? WholeVector{0, 1, 0} : WholeVector{x * n[2], y * n[2], -g};
    for (;;) {
      second = plus(second, -nearest(dot(first, second), dot(first, first)), first);
      if (dot(second, second) >= dot(first, first)) break;
      std::swap(first, second);
    }
    unit = shortened({x * u, y * u, w});
  }

  /// `v` moved along the plane to near the origin.
  [[nodiscard]] WholeVector shortened(const WholeVector& v) const {
    const Whole a = dot(first, first), b = dot(first, second), c = dot(second, second);
    const Whole p = dot(first, v), q = dot(second, v), area = a * c - b * b;
    return plus(plus(v, -nearest(c * p - b * q, area), first), -nearest(a * q - b * p, area), second);
  }
  /// The whole point with n·x = value near `from`.
  [[nodiscard]] WholeVector point_near(const WholeVector& from, const Whole& value) const {
    const Whole steps = value - dot(normal, from);
    return plus(from, 1, shortened({steps * unit[0], steps * unit[1], steps * unit[2]}));
  }
};

/// A number of `bits` bits; of less than one bit it is 1.
[[nodiscard]] inline Whole some_whole(Random& random, int bits) {
  const Whole some = (Whole(1) << 30) + Whole(random.between(0, (1 << 30) - 1));
  if (bits < 1) return 1;
  return bits < 31 ? some >> (31 - bits) : some << (bits - 31);
}

}  // namespace rayproof::lattice
