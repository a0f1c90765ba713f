#pragma once
/// \file
/// Numbers with the size that a bound on their rounding is measured by.

#include <concepts>
#include <rayproof/vec3.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// A number, and what it would be if no sum had cancelled: |x·y| + |z| of x·y - z. Where k roundings lead to
/// each of its terms, it is off by no more than k·u·size and terms in u², u the unit roundoff: an a-priori
/// bound, with k counted by the reader of the formula, in a third of what running errors cost (Bounded).
///
/// `W` is plain, a pack, or a double-double. Source: N. J. Higham, "Accuracy and Stability of Numerical
/// Algorithms", ch. 3.1, 2002.
template <class W>
struct Sized {
  W value;
  Leading<W> size;

  constexpr Sized(const W& number, const Leading<W>& measure) : value(number), size(measure) {}
  /// A number that is given, or that is to count as one.
  template <class Number>
  requires std::constructible_from<W, Number>
  constexpr explicit Sized(const Number& given) : value(given), size(abs(leading(value))) {}

  /// The same number in all lanes of a pack.
  template <class U>
  requires std::constructible_from<W, U>
  constexpr explicit Sized(const Sized<U>& same) : value(same.value), size(same.size) {}

  friend constexpr Sized operator+(const Sized& x, const Sized& y) {
    return {x.value + y.value, x.size + y.size};
  }
  friend constexpr Sized operator-(const Sized& x, const Sized& y) {
    return {x.value - y.value, x.size + y.size};
  }
  friend constexpr Sized operator*(const Sized& x, const Sized& y) {
    return {x.value * y.value, x.size * y.size};
  }
  friend constexpr Sized sum_of_products(const Sized& a, const Sized& b, const Sized& c, const Sized& d,
                                         const Sized& e, const Sized& f) {
    return {sum_of_products(a.value, b.value, c.value, d.value, e.value, f.value),
            a.size * b.size + c.size * d.size + e.size * f.size};
  }
};

/// A vector whose components count as given numbers.
template <class W>
[[nodiscard]] constexpr Vec3<Sized<W>> sized(const vec3<W>& v) {
  return {Sized<W>(v.x), Sized<W>(v.y), Sized<W>(v.z)};
}

/// a × b of two vectors that are given, with what its components may be off by, in unit roundoffs:
/// themselves, where the difference of two exact products is rounded once, and the sizes of the products
/// where that is a difference of numbers in several parts.
template <class W>
[[nodiscard]] constexpr Vec3<Sized<W>> sized_cross(const vec3<W>& a, const vec3<W>& b) {
  if constexpr (std::same_as<W, Leading<W>>) {
    return sized<W>(cross(a, b));
  } else {
    return cross(sized<W>(a), sized<W>(b));
  }
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
