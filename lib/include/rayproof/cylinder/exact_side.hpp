#pragma once
#include <rayproof/box/exact_slab.hpp>
#include <rayproof/cylinder.hpp>
#include <utility>

namespace rayproof::cylinder {

/// The exact equation A·t² + 2·B·t + C = 0 of a line and a cylinder's side, free of division: both sides are
/// multiplied by rx²·ry². A quarter of its discriminant is (rx·ry)²·E with E = A - (o.x·d.y - o.y·d.x)².
struct ExactSide {
  using Time = box::ExactTime<2, 1>;

  Expansion<double, 16> A, B;
  Expansion<double, 24> C;
  Expansion<double, 48> E;
  double half_chord = 0;  ///< √E·rx·ry, rounded: what A·t + B comes to at the upper root
  std::array<double, 2> approximate{0, 0};  ///< the roots to within 2^-49 of their size, where E > 0

  template <class T>
  ExactSide(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    const auto o = exact_vector<double>(ray.origin);
    const auto d = exact_vector<double>(ray.direction);
    const auto rx = exact(static_cast<double>(cylinder.rx));
    const auto ry = exact(static_cast<double>(cylinder.ry));
    const auto [fx, fy] = std::pair(o.x * ry, o.y * rx);
    const auto [dx, dy] = std::pair(d.x * ry, d.y * rx);
    const auto area = rx * ry;
    const auto moment = o.x * d.y - o.y * d.x;
    A = dx * dx + dy * dy;
    B = fx * dx + fy * dy;
    C = fx * fx + fy * fy - area * area;
    E = A - moment * moment;
    if (!(sign(A) > 0 && sign(E) > 0)) return;
    half_chord = sqrt(estimate(E)) * abs(estimate(area));
    // One root from the sum in which nothing cancels, the other from Viète.
    const double q = -(estimate(B) + copysign(half_chord, estimate(B)));
    const double x0 = q / estimate(A);
    const double x1 = estimate(C) / q;
    approximate = {min(x0, x1), max(x0, x1)};
  }

  /// The sign of (root - numerator/denominator) for the lower (side = -1) or upper (side = 1) root, exactly.
  template <std::size_t N>
  [[nodiscard]] int compare(int side, const ExactRatio<N, 1>& x) const {
    const auto& [n, m] = x;
    const int value = sign(A * (n * n) + exact(2.0) * B * (n * m) + C * (m * m));
    return compare_root(side, value, sign(A * n + B * m) * sign(m));
  }
  [[nodiscard]] int compare(int side, double t) const {
    return compare(side, ExactRatio{exact(t), exact(1.0)});
  }
  /// The same, sparing the exact products where the approximate numbers are clear of each other.
  [[nodiscard]] int compare(int side, const Time& x) const {
    const double t = approximate[side < 0 ? 0 : 1];
    const double difference = t - x.approximate;
    const double doubt = 0x1p-46 * (abs(t) + abs(x.approximate)) + std::numeric_limits<double>::min();
    if (sign(E) > 0 && abs(difference) > doubt) return difference > 0 ? 1 : -1;
    return compare(side, x.ratio);
  }

  /// A root in T, on its own side of the ends of the ray's interval. A double root is the same number on both
  /// sides.
  template <class T>
  [[nodiscard]] T root(const Ray<T>& ray, int side) const {
    if (sign(E) == 0) return rounded(ray, ExactRatio{-B, A});
    double t = approximate[side < 0 ? 0 : 1];
    if (sizeof(T) == sizeof(double) && abs(t) < infinity<double>) t -= excess(side, t);
    const auto compare_with = [&](double x) { return compare(side, x); };
    return keep_side(ray, narrowed<T>(t, compare_with), compare_with);
  }

 private:
  /// How far t is above the root: the exact value there over the exact slope between t and the root.
  [[nodiscard]] double excess(int side, double t) const {
    const double slope = estimate(A * exact(t) + B) + side * half_chord;
    return slope == 0 ? 0 : estimate((A * exact(t) + exact(2.0) * B) * exact(t) + C) / slope;
  }
};

}  // namespace rayproof::cylinder
