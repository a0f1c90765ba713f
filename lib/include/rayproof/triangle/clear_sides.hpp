#pragma once
/// \file
/// A triangle met with more digits, and with a bound on the error, for the rounding test.

#include <rayproof/formulas/rounding_test.hpp>
#include <rayproof/triangle.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// The volume of three vectors and a bound on its rounding error.
template <class W>
struct Volume {
  W value;
  Leading<W> error;
  [[nodiscard]] constexpr Mask<W> is_positive() const { return leading(value) > error; }
  [[nodiscard]] constexpr Mask<W> is_negative() const { return leading(value) < -error; }
};

/// The three sides and the numerators of a ray and a triangle, with bounds on their rounding errors: what is
/// clear needs no exact arithmetic. `T` is double, double-double, or a pack of either.
///
/// Every number here is the volume of three vectors that are differences of inputs. With |x| the sum of a
/// vector's magnitudes its error is less than 8u·|x||y||z|: at most two roundings of differences and six of
/// the volume, each u, the unit roundoff, of no more than that product; the bound is twice as much. Nothing
/// may underflow: true of floats in double and of what double-doubles are made of; of doubles in double only
/// within the domain of the caller.
template <class T>
struct ClearSides {
  using N = Leading<T>;
  Volume<T> U, V, W;    ///< of the same sign, or two of them clear and of different signs: the ray passes by
  Volume<T> D;          ///< U + V + W in real numbers
  Volume<T> at_origin;  ///< t = at_origin / D

  /// Where products may underflow, `least` is added to every size.
  [[nodiscard]] static constexpr ClearSides of(const Ray<T>& ray, const Triangle<T>& triangle,
                                               const N& least = N(0)) {
    const auto size = [&](const vec3<T>& x) {
      const N sum = abs(leading(x.x)) + abs(leading(x.y)) + abs(leading(x.z));
      return is_known_zero(least) ? sum : sum + least;
    };
    const vec3<T> d = ray.direction;
    const vec3<T> a = triangle.a - ray.origin;
    const vec3<T> b = triangle.b - ray.origin;
    const vec3<T> ab = triangle.b - triangle.a;
    const vec3<T> ac = triangle.c - triangle.a;
    const vec3<T> bc = triangle.c - triangle.b;
    const vec3<T> da = cross(d, a), db = cross(d, b), normal = cross(ab, ac);
    const N bound(16 * unit_roundoff<T>);
    const N size_d = bound * size(d), size_ab = size(ab), size_ac = size(ac);
    const N size_normal = size_ab * size_ac;
    const N size_da = size_d * size(a);
    // b×c = b×(c-b): so formed, the sides of a small far triangle keep their digits.
    return {{dot(db, bc), size_d * size(b) * size(bc)},
            {-dot(da, ac), size_da * size_ac},
            {dot(da, ab), size_da * size_ab},
            {dot(d, normal), size_d * size_normal},
            {dot(a, normal), bound * size(a) * size_normal}};
  }

  /// Two sides are clear and of different signs: the ray passes by.
  [[nodiscard]] constexpr Mask<T> is_miss() const {
    return (U.is_positive() || V.is_positive() || W.is_positive()) &&
           (U.is_negative() || V.is_negative() || W.is_negative());
  }

  /// All sides are clear and of one sign.
  [[nodiscard]] constexpr Mask<T> is_inside() const {
    return (U.is_positive() && V.is_positive() && W.is_positive()) ||
           (U.is_negative() && V.is_negative() && W.is_negative());
  }

  /// The hit of a ray that is inside. A quotient of volumes is off by the errors of both and three roundings,
  /// two of them the test's; the bounds, twice as large as they need be, leave room for what D's error does
  /// to the divisor, of which it is no more than a 2^-20th.
  [[nodiscard]] constexpr EnclosedHit<T> hit() const {
    const N abs_D = abs(leading(D.value)), per_D = reciprocal_bound(abs_D);
    const auto error_of = [&](const T& x, const Volume<T>& numerator) {
      const N size_x = abs(leading(x));
      return (numerator.error + size_x * D.error) * per_D + N(4 * unit_roundoff<T>) * size_x;
    };
    const T t = at_origin.value / D.value, u = V.value / D.value, v = W.value / D.value;
    const Mask<T> is_hit = is_inside();
    const Mask<T> has_digits = N(0x1p20) * D.error < abs_D;
    return {{{select(is_hit, T(0), T(-1)), t, t}, u, v},
            error_of(t, at_origin),
            error_of(u, V),
            error_of(v, W),
            (is_hit && has_digits) || is_miss()};
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
