#pragma once
/// \file
/// A ray and a cylinder without rounding: verdicts by expansions, tangents and rims that are touched
/// included.

#include <rayproof/box/exact_slab.hpp>
#include <rayproof/cylinder/side.hpp>
#include <rayproof/formulas/expanded_quadratic.hpp>
#include <rayproof/method/method.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::cylinder {

/// The exact equation a·t² - 2·b·t + c = 0 of a line and a cylinder's side, free of division: both sides are
/// multiplied by rx²·ry². A quarter of its discriminant is (rx·ry)²·E with E = a - (o.x·d.y - o.y·d.x)².
template <class Equation, class Number>
struct ExactSide {
  Equation equation;  ///< has roots where a > 0 and E >= 0
  Number E;

  /// The exact sign of (root - x) for the lower (side = -1) or upper (side = 1) root; exact products are
  /// spared where the approximate numbers are clear of each other.
  template <class Numerator, class Denominator>
  [[nodiscard]] int compare(int side, const ExactRatio<Numerator, Denominator>& x) const {
    const double t = equation.approximate(side);
    const double difference = t - x.approximate;
    const double doubt = 0x1p-46 * (abs(t) + abs(x.approximate));
    if (sign(E) > 0 && abs(difference) > doubt) return difference > 0 ? 1 : -1;
    return equation.compare(side, x);
  }

  /// A root in T, on its own side of the ends of the ray's interval. A double root is the same number on both
  /// sides.
  template <class T>
  [[nodiscard]] T root(const Ray<T>& ray, int side) const {
    return sign(E) == 0 ? rounded(ray, ExactRatio{equation.b, equation.a}) : equation.root(ray, side);
  }
};
template <class Equation, class Number>
ExactSide(Equation, Number) -> ExactSide<Equation, Number>;

/// The side that a ray from o along d meets, as met_exactly has them: a, b and c count unit² times, E unit⁴.
template <class T, class Vector, class Unit>
[[nodiscard]] auto exact_side(const Vector& o, const Vector& d, const Unit& unit,
                              const Cylinder<T>& cylinder) {
  const auto rx = exact(double{cylinder.rx});
  const auto ry = exact(double{cylinder.ry});
  const auto [fx, fy] = std::pair(o.x * ry, o.y * rx);
  const auto [dx, dy] = std::pair(d.x * ry, d.y * rx);
  const auto area = rx * ry;
  const auto radius = unit * area;
  const auto moment = o.x * d.y - o.y * d.x;
  const auto a = dx * dx + dy * dy;
  const auto minus_b = fx * dx + fy * dy;
  const auto c = fx * fx + fy * fy - radius * radius;
  const auto E = unit * (unit * a) - moment * moment;
  const double s = sign(E) > 0 ? sqrt(estimate(E)) * abs(estimate(area)) : 0;
  // One root from the sum in which nothing cancels, the other from Viète.
  const double q = -(estimate(minus_b) + copysign(s, estimate(minus_b)));
  const double t0 = q / estimate(a);
  const double t1 = estimate(c) / q;
  return ExactSide{ExpandedQuadratic{a, -minus_b, c, s, std::array{min(t0, t1), max(t0, t1)}}, E};
}

/// The hits by expansions alone: the side's equation and discriminant, and every comparison of a root with a
/// height, are exact, and what is hit is rounded once.
struct ExactCylinderHits {
  /// Of a ray from o along d, as met_exactly has them.
  template <std::floating_point T, class Vector, class Unit>
  [[nodiscard]] static Roots<T> meet(const Ray<T>& ray, const Cylinder<T>& cylinder, const Vector& o,
                                     const Vector& d, const Unit& unit) {
    const vec3<T> size{cylinder.rx, cylinder.ry, cylinder.height};
    const bool is_solid = size.x != 0 && size.y != 0 && size.z >= 0;
    if (!is_solid || !are_finite(size)) return no_roots<T>;

    step<T>(
        "Form the distances to both ends exactly",
        "The ray meets z = 0 and z = height at quotients of these differences, and none of them is rounded.");
    const auto bottom = unit * exact(0.0) - o.z, top = unit * exact(double{cylinder.height}) - o.z;
    const bool is_mirrored = sign(unit) < 0;  // times a negative number the top is below
    const box::ExactSlab heights(d.z, is_mirrored ? top : bottom, is_mirrored ? bottom : top);
    if (heights.is_parallel && !heights.is_between) return no_roots<T>;

    step<T>("Form the coefficients and the discriminant of the side exactly",
            "The sign of an exact discriminant says with certainty whether the line meets the side.");
    const auto side = exact_side(o, d, unit, cylinder);
    if (sign(side.equation.a) == 0) return along_axis(ray, cylinder, side, heights);
    if (sign(side.E) < 0) return no_roots<T>;

    step<T>("Compare the roots with the ends, and round what is hit",
            "Exact comparisons of roots and ends decide which of them are hits; only then is t rounded.");
    const bool is_open = !cylinder.capped || sign(side.E) == 0;  // a tangent meets no cap's inside
    return is_open ? open(ray, side, heights) : capped(ray, side, heights);
  }

 private:
  /// The signs of (root - entry) and (root - exit) for one root of the side; a line that runs between both
  /// ends never enters nor leaves.
  struct Place {
    int after_entry = 1;
    int after_exit = -1;
    [[nodiscard]] bool is_between() const { return after_entry >= 0 && after_exit <= 0; }
  };
  template <class Side, class Heights>
  static Place place(const Side& side, int which, const Heights& heights) {
    if (heights.is_parallel) return {};
    return {side.compare(which, heights.entry), side.compare(which, heights.exit)};
  }

  template <class T, class Side, class Heights>
  static Roots<T> along_axis(const Ray<T>& ray, const Cylinder<T>& cylinder, const Side& side,
                             const Heights& heights) {
    const bool is_ring = cylinder.height == 0;  // an open cylinder of no height is all rim
    const bool meets = cylinder.capped ? sign(side.equation.c) <= 0 : is_ring && sign(side.equation.c) == 0;
    if (!meets || heights.is_parallel) return no_roots<T>;
    const Roots<T> both{T(1), rounded(ray, heights.entry), rounded(ray, heights.exit)};
    return kept(both, !is_ring, true);
  }

  template <class T, class Side, class Heights>
  static Roots<T> open(const Ray<T>& ray, const Side& side, const Heights& heights) {
    const bool is_lo = place(side, -1, heights).is_between();
    const bool is_hi = place(side, 1, heights).is_between();
    if (!is_lo && !is_hi) return no_roots<T>;
    const Roots<T> both = ascending(T(sign(side.E)), side.root(ray, -1), side.root(ray, 1));
    return kept(both, is_lo, is_hi);
  }

  template <class T, class Side, class Heights>
  static Roots<T> capped(const Ray<T>& ray, const Side& side, const Heights& heights) {
    const Place lo = place(side, -1, heights);
    const Place hi = place(side, 1, heights);
    if (hi.after_entry < 0 || lo.after_exit > 0) return no_roots<T>;
    const bool is_flat = !heights.is_parallel && heights.entry.compare(heights.exit) == 0;
    const bool is_one = hi.after_entry == 0 || lo.after_exit == 0 || is_flat;
    const T entry = lo.after_entry >= 0 ? side.root(ray, -1) : rounded(ray, heights.entry);
    const T exit = hi.after_exit <= 0 ? side.root(ray, 1) : rounded(ray, heights.exit);
    const Roots<T> both = ascending(T(1), entry, exit);
    return kept(both, !is_one, true);
  }
};

}  // namespace rayproof::cylinder

#include <rayproof/rounding/as_before.hpp>
