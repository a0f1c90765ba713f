#pragma once
/// \file
/// t where a ray's line meets a polygon's plane, as a quotient: without rounding, and with a bound.

#include <rayproof/arithmetics/growing_expansion.hpp>
#include <rayproof/arithmetics/sized.hpp>
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <vector>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// t = N / D without rounding, with the exact Newell normal.
struct ExactQuotient {
  using Exact = GrowingExpansion<double>;
  using Ratio = ExactRatio<Expansion<double, 24>, Expansion<double, 24>>;
  Vec3<Exact> normal;
  Exact N, D;

  [[nodiscard]] static ExactQuotient of(const Ray<double>& ray, const Polygon<double>& polygon) {
    const auto vertices = convert<Exact>(polygon).vertices;
    const Vec3<Exact> n = newell_normal<Exact>(vertices, vertices.front());
    return {n, dot(n, vertices.front() - convert<Exact>(ray.origin)), dot(n, convert<Exact>(ray.direction))};
  }
  /// For exact_rounding.hpp. Within the method's domain the digits of both span no more than 1200 bits.
  [[nodiscard]] Ratio ratio() const { return {compressed<24>(N), compressed<24>(D)}; }
};

/// The same in double or in double-double, and how much of it is sure.
///
/// With u the unit roundoff, of k vertices less the first each is off by u of itself, their products by 3u,
/// and a component of the normal by (k + 3)u of its size; so N and D are off by (k + 7)u of theirs, and the
/// quotient, where D has digits, by that of both and one rounding more. The bound leaves as much again.
template <class W>
struct EnclosedQuotient {
  Vec3<Sized<W>> normal;
  Sized<W> N, D;
  double relative;  ///< what both are off by, in parts of their sizes

  [[nodiscard]] static EnclosedQuotient of(const Ray<W>& ray, const Polygon<W>& polygon) {
    const vec3<W> first = polygon.vertices.front();
    std::vector<Vec3<Sized<W>>> seen_from_first;
    seen_from_first.reserve(polygon.vertices.size());
    for (const vec3<W>& vertex : polygon.vertices) seen_from_first.push_back(sized<W>(vertex - first));
    const Sized<W> zero(W(0));
    const auto n = newell_normal<Sized<W>>(seen_from_first, {zero, zero, zero});
    return {n, dot(n, sized<W>(first - ray.origin)), dot(n, sized<W>(ray.direction)),
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
