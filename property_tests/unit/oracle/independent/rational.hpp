#pragma once
/// \file
/// The oracle's answers, computed independently: CGAL's exact geometry over GMP's rational numbers, which
/// divides where the oracle does not, and shares nothing with it but the case.

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {

/// Exact, with division.
using Rational = CGAL::Gmpq;
/// A kernel without filters: every test in it is a test of rational numbers.
using Kernel = CGAL::Simple_cartesian<Rational>;
using Point = Kernel::Point_3;
using Vector3 = Kernel::Vector_3;

[[nodiscard]] inline Point point_of(const glm::dvec3& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}
[[nodiscard]] inline Vector3 vector_of(const glm::dvec3& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

[[nodiscard]] inline CGAL::Aff_transformation_3<Kernel> map_of(const glm::dmat4& m) {
  const auto at = [&](int row, int column) { return Rational(m[column][row]); };
  return {at(0, 0), at(0, 1), at(0, 2), at(0, 3), at(1, 0), at(1, 1),
          at(1, 2), at(1, 3), at(2, 0), at(2, 1), at(2, 2), at(2, 3)};
}

/// The ray's line in the world, and in the shape's own space; t is the same number in both.
struct RationalRay {
  Point origin;
  Vector3 direction;
  Point world_origin;
  Vector3 world_direction;
  std::optional<CGAL::Aff_transformation_3<Kernel>> to_world;

  explicit RationalRay(const RayQuestion& asked)
      : origin(point_of(asked.ray.origin)),
        direction(vector_of(asked.ray.direction)),
        world_origin(origin),
        world_direction(direction) {
    if (!asked.transform) return;
    to_world = map_of(*asked.transform);
    const auto to_object = to_world->inverse();
    origin = to_object.transform(origin);
    direction = to_object.transform(direction);
  }

  [[nodiscard]] Kernel::Line_3 line() const { return {origin, direction}; }
  /// The t of a point of the line.
  [[nodiscard]] Rational t_of(const Point& p) const {
    const int axis = direction.x() != 0 ? 0 : direction.y() != 0 ? 1 : 2;
    return (p[axis] - origin[axis]) / direction[axis];
  }
};

/// Whether t is in the ray's closed interval; for any number that compares with rational ones.
template <class Number>
[[nodiscard]] bool is_within(const Number& t, const Ray<double>& ray) {
  return (std::isinf(ray.t_min) || t >= Rational(ray.t_min)) &&
         (std::isinf(ray.t_max) || t <= Rational(ray.t_max));
}

/// The next number of the precision above x, and the greatest of them all.
[[nodiscard]] inline double above(double x, Precision precision) {
  if (precision == Precision::float64) return std::nextafter(x, infinity<double>);
  return static_cast<double>(std::nextafter(static_cast<float>(x), infinity<float>));
}
[[nodiscard]] inline bool has_even_digits(double x, Precision precision) {
  if (precision == Precision::float64) return (std::bit_cast<std::uint64_t>(x) & 1U) == 0;
  return (std::bit_cast<std::uint32_t>(static_cast<float>(x)) & 1U) == 0;
}

/// The boundary between what rounds to x and what rounds to the next number above it.
[[nodiscard]] inline Rational boundary_above(double x, Precision precision) {
  const double next = above(x, precision);
  if (!std::isinf(next)) return (Rational(x) + Rational(next)) / 2;
  const double ulp = precision == Precision::float32 ? 0x1p+104 : 0x1p+971;
  return Rational(x) + Rational(ulp) / 2;
}

/// Whether x is the number of the precision that is nearest to the exact one, ties to even; for any number
/// that compares with rational ones.
template <class Number>
[[nodiscard]] bool is_nearest(double x, const Number& exact, Precision precision) {
  if (x < 0 || (x == 0 && exact < 0)) return is_nearest(-x, Number(-exact), precision);
  const bool narrow = precision == Precision::float32;
  const double greatest = narrow ? double{FLT_MAX} : DBL_MAX;
  if (std::isinf(x)) return exact >= boundary_above(greatest, precision);
  if (narrow && x != static_cast<double>(static_cast<float>(x))) return false;
  const bool even = has_even_digits(x, precision);
  const Rational top = boundary_above(x, precision);
  if (exact > top || (exact == top && !even)) return false;
  const double below = -above(-x, precision);
  const Rational bottom = x == 0 ? -top : boundary_above(below, precision);
  return exact > bottom || (exact == bottom && even);
}

}  // namespace rayproof::oracle::test
