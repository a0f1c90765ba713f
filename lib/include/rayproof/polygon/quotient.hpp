#pragma once
/// \file
/// t where a ray's line meets a polygon's plane, as a quotient: without rounding, and with a bound.

#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/arithmetics/sized.hpp>
#include <rayproof/formulas/exact_map.hpp>
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/formulas/polygon_sides.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// t = N / D without rounding, with the exact Newell normal.
struct ExactQuotient {
  using Exact = GrowingExpansion<double>;
  using Ratio = ExactRatio<Expansion<double, 24>, Expansion<double, 24>>;
  Vec3<Exact> normal;
  Exact N, D;

  /// Of a ray from o along d, as met_exactly has them.
  template <class Vector, class Unit, class T>
  [[nodiscard]] static ExactQuotient of(const Vector& o, const Vector& d, const Unit& unit,
                                        const Polygon<T>& polygon) {
    const auto exact_vertex = [&](std::size_t i) { return convert<Exact>(polygon.vertices[i]); };
    const Vec3<Exact> first = exact_vertex(0);
    const Vec3<Exact> n = newell_normal<Exact>(MadeInTurn{polygon.vertices.size(), exact_vertex}, first);
    return {n, dot(n, unit * first - convert<Exact>(o)), dot(n, convert<Exact>(d))};
  }
  /// For exact_rounding.hpp. Within the method's domain the digits of both span no more than 1200 bits.
  [[nodiscard]] Ratio ratio() const { return {compressed<24>(N), compressed<24>(D)}; }
};

/// The same in double or in double-double, and how much of it is sure.
///
/// With u the unit roundoff, of k vertices less the first each is off by u of itself, their products by 3u,
/// and a component of the normal by (k + 3)u of its size; so N and D are off by (k + 7)u of theirs, and the
/// quotient, where D has digits, by that of both and one rounding more. The bound leaves as much again: room
/// for a ray that is not given, but off by 5.1u of each coordinate, where N's size has that of its origin.
template <class W>
struct EnclosedQuotient {
  Vec3<Sized<W>> normal;
  Sized<W> N, D;
  double relative;  ///< what both are off by, in parts of their sizes

  template <class T>
  [[nodiscard]] static EnclosedQuotient of(const Ray<W>& ray, const Polygon<T>& polygon,
                                           bool is_ray_given = true) {
    const auto first = convert<W>(polygon.vertices.front());
    const auto seen_from_first = [&](std::size_t i) {
      return sized<W>(convert<W>(polygon.vertices[i]) - first);
    };
    const Sized<W> zero(W(0));
    const auto n =
        newell_normal<Sized<W>>(MadeInTurn{polygon.vertices.size(), seen_from_first}, {zero, zero, zero});
    const auto o = sized<W>(ray.origin);
    const auto ahead = is_ray_given ? sized<W>(first - ray.origin) : sized<W>(first) - o;
    return {n, dot(n, ahead), dot(n, sized<W>(ray.direction)),
            2 * unit_roundoff<W> * (static_cast<double>(polygon.vertices.size()) + 8)};
  }

  [[nodiscard]] vec3<double> normal_in_double() const {
    return {leading(normal.x.value), leading(normal.y.value), leading(normal.z.value)};
  }
  [[nodiscard]] W t() const { return N.value / D.value; }
  /// A bound on t's error less two roundings; infinite where the digits of D may be lost.
  [[nodiscard]] double error_of_t() const {
    if (!has_digits()) return infinity<double>;
    return relative * (N.size + abs(leading(t())) * D.size) / abs(leading(D.value));
  }
  [[nodiscard]] bool has_digits() const { return 0x1p20 * relative * D.size < abs(leading(D.value)); }
  /// The sign of D is that of the exact one and its digits are good; so is the choice of the normal's largest
  /// component.
  [[nodiscard]] bool is_sure() const {
    const auto n = normal_in_double();
    const double doubt = 2 * relative * max(normal.x.size, max(normal.y.size, normal.z.size));
    const double a = abs(n.x), b = abs(n.y), c = abs(n.z);
    const double largest = max(a, max(b, c));
    const int rivals = int{largest - a <= doubt} + int{largest - b <= doubt} + int{largest - c <= doubt};
    return rivals == 1 && has_digits();
  }
};

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
