#pragma once
#include <rayproof/cylinder/exact_side.hpp>
#include <rayproof/cylinder/side.hpp>
#include <rayproof/method/contract.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/method/sources.hpp>

namespace rayproof::cylinder {

/// The side's equation and discriminant by exact expansions, and every comparison of a root with a height
/// exact: the verdict is the exact one, tangents and rims that are touched included.
///
/// An answer is never rounded across an end of the ray's interval. Holds for all finite floats; for doubles
/// while every number that is not 0 lies within 2^±100, beyond which the products, of degree six, or a root
/// itself over- or underflow. Radii of 0 and negative heights make no cylinder and are missed.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "exact discriminant and heights by expansions";
  static constexpr Source source = sources::shewchuk;
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0},
      .residual = {.measured = 1, .promised = 4},
      .ulp = {.measured = 0.501, .promised = 1},
      .domain = {.reach_float = 1000, .reach_double = 100, .every_number = true},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::ulp, Claim::robust,
                                       Claim::moved, Claim::scaled, Claim::reversed}};

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    const vec3<T> size{cylinder.rx, cylinder.ry, cylinder.height};
    const bool is_solid = size.x != 0 && size.y != 0 && size.z >= 0;
    if (!is_solid || !are_finite(ray.origin, ray.direction, size)) return miss<T>;

    step<T>(
        "Form the distances to both ends exactly",
        "The ray meets z = 0 and z = height at quotients of these differences, and none of them is rounded.");
    const auto o_z = exact(static_cast<double>(ray.origin.z));
    const auto height = exact(static_cast<double>(cylinder.height));
    const Heights heights(exact(static_cast<double>(ray.direction.z)), Expansion<double, 1>() - o_z,
                          height - o_z);
    if (heights.is_parallel && !heights.is_between) return miss<T>;

    step<T>("Form the coefficients and the discriminant of the side exactly",
            "The sign of an exact discriminant says with certainty whether the line meets the side.");
    const ExactSide side(ray, cylinder);
    if (sign(side.A) == 0) return along_axis(ray, cylinder, side, heights);
    if (sign(side.E) < 0) return miss<T>;

    step<T>("Compare the roots with the ends, and round what is hit",
            "Exact comparisons of roots and ends decide which of them are hits; only then is t rounded.");
    const bool is_open = !cylinder.capped || sign(side.E) == 0;  // a tangent meets no cap's inside
    return is_open ? open(ray, side, heights) : capped(ray, side, heights);
  }

 private:
  using Heights = box::ExactSlab<2, 1>;
  template <class T>
  static constexpr Roots<T> miss{T(-1), not_a_number<T>, not_a_number<T>};

  /// The signs of (root - entry) and (root - exit) for one root of the side; a line that runs between both
  /// ends never enters nor leaves.
  struct Place {
    int after_entry = 1;
    int after_exit = -1;
    [[nodiscard]] bool is_between() const { return after_entry >= 0 && after_exit <= 0; }
  };
  static Place place(const ExactSide& side, int which, const Heights& heights) {
    if (heights.is_parallel) return {};
    return {side.compare(which, heights.entry), side.compare(which, heights.exit)};
  }

  template <class T>
  static Roots<T> along_axis(const Ray<T>& ray, const Cylinder<T>& cylinder, const ExactSide& side,
                             const Heights& heights) {
    const bool is_ring = cylinder.height == 0;  // an open cylinder of no height is all rim
    const bool meets = cylinder.capped ? sign(side.C) <= 0 : is_ring && sign(side.C) == 0;
    if (!meets || heights.is_parallel) return miss<T>;
    const Roots<T> both{T(1), rounded(ray, heights.entry.ratio), rounded(ray, heights.exit.ratio)};
    return kept(both, !is_ring, true);
  }

  template <class T>
  static Roots<T> open(const Ray<T>& ray, const ExactSide& side, const Heights& heights) {
    const bool is_lo = place(side, -1, heights).is_between();
    const bool is_hi = place(side, 1, heights).is_between();
    if (!is_lo && !is_hi) return miss<T>;
    const Roots<T> both = ascending(T(sign(side.E)), side.root(ray, -1), side.root(ray, 1));
    return kept(both, is_lo, is_hi);
  }

  template <class T>
  static Roots<T> capped(const Ray<T>& ray, const ExactSide& side, const Heights& heights) {
    const Place lo = place(side, -1, heights);
    const Place hi = place(side, 1, heights);
    if (hi.after_entry < 0 || lo.after_exit > 0) return miss<T>;
    const bool is_flat = !heights.is_parallel && heights.entry.compare(heights.exit) == 0;
    const bool is_one = hi.after_entry == 0 || lo.after_exit == 0 || is_flat;
    const T entry = lo.after_entry >= 0 ? side.root(ray, -1) : rounded(ray, heights.entry.ratio);
    const T exit = hi.after_exit <= 0 ? side.root(ray, 1) : rounded(ray, heights.exit.ratio);
    const Roots<T> both = ascending(T(1), entry, exit);
    return kept(both, !is_one, true);
  }
};

}  // namespace rayproof::cylinder
