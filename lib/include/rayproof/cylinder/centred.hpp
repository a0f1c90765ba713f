#pragma once
#include <rayproof/cylinder/side.hpp>
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::cylinder {

/// The side by geometry: in the plane where it is the unit circle, 1 less the squared distance of the line
/// from the axis, formed at the point nearest the axis; then half a chord to either side of that point, and
/// the heights.
///
/// As good far away as near by, as sphere::Centred is.
struct Centred {
  static constexpr const char* name = "centred";
  static constexpr const char* title = "discriminant from the point nearest the axis";
  static constexpr Source source = sources::haines_2019;
  static constexpr Contract contract{
      .verdict = {.measured = 3.99, .promised = cylinder_robust_bound},
      .residual = {.measured = 4.19, .promised = cylinder_robust_bound},
      .hit = cylinder_hit_bounds,
      .domain = {.reach_float = 20, .reach_double = 200, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    const auto [fx, fy, dx, dy] = scaled_to_circle(ray, cylinder);

    step<T>("Find the point nearest the axis",
            "t_c is where the ray comes nearest the axis, seen in the scaled plane. l leads from the axis to "
            "that point and is perpendicular to d there.");
    const T per_a = named("1/a", T(1) / (dx * dx + dy * dy));
    const T t_c = named("t_c", -(fx * dx + fy * dy) * per_a);
    const T lx = named("l.x", fx + t_c * dx);
    const T ly = named("l.y", fy + t_c * dy);

    step<T>(steps::compare_with_radius);
    const T D = named("D", T(1) - (lx * lx + ly * ly));

    return hits<T>(ray, cylinder, ends_of_chord(t_c, D, per_a, "s₀", "s₁"), fx * fx + fy * fy - T(1));
  }
};

}  // namespace rayproof::cylinder

#include <rayproof/rounding/as_before.hpp>
