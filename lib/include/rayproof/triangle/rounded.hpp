#pragma once
#include <rayproof/formulas/bounded_roots.hpp>
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/clear_sides.hpp>
#include <rayproof/triangle/correction.hpp>
#include <rayproof/triangle/plucker.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// Correctly rounded: the verdict is the exact one, edges, vertices and rays inside the plane included, and
/// t, u and v are the exact ones rounded once, ties to even: u and v are off by ε/2 and 1 - u - v by 2ε at
/// most.
///
/// The three Plücker sides with a bound on their rounding (ClearSides) go first, in double for a ray in
/// float, in double-double for one in double, in packs too. They decide what is clearly a miss, or a hit with
/// a sure rounding, which is nearly everywhere; the rest goes to the same sides as exact expansions. No
/// answer is rounded across an end of the ray's interval.
///
/// Holds for all finite floats; for doubles while every number that is not 0 lies within 2^±200, beyond which
/// terms of the expansions over- or underflow; under a transform within 2^±24.
struct Rounded {
  static constexpr const char* name = "rounded";
  static constexpr const char* title =
      "correctly rounded: three sides with more digits, exact where in doubt";
  static constexpr Source source = sources::ziv;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.433, .promised = 2},
      .ulp = {.measured = 0.5, .promised = 0.501},
      .hit = {triangle_hit_bounds.point,
              triangle_hit_bounds.normal,
              {.measured = 1.22, .promised = 2, .is_proven = true}},
      .domain = {.reach_float = 1000, .reach_double = 200, .every_number = true},
      .holds = robust_claims | hit_claims |
               Claims{Claim::coordinates, Claim::residual, Claim::ulp, Claim::rounded, Claim::bounded}};

  /// What is tried first where the nearest hit alone is asked for.
  using Correction = triangle::Correction;

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    return quick_or_exact_roots<Rounded>(ray, triangle);
  }

  template <class W>
  [[nodiscard]] static constexpr EnclosedHit<W> enclosed(const Ray<W>& ray, const Triangle<W>& triangle) {
    return ClearSides<W>::of(ray, triangle).hit();
  }

  /// By expansions, but for a miss that is clear.
  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> exact_roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    const auto clear = ClearSides<double>::of(convert<double>(ray), convert<double>(triangle));
    return clear.is_miss() ? no_hit<T> : met_exactly<Rounded>(ray, triangle);
  }

  /// The same under a transform.
  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                                 const Triangle<T>& triangle) {
    return quick_or_exact_roots<Rounded>(space, ray, triangle);
  }

  /// Plucker of a ray in object space whose numbers have bounds on their errors.
  template <class W>
  [[nodiscard]] static constexpr EnclosedHit<W> enclosed_in_space(const Ray<Bounded<W>>& ray,
                                                                  const Triangle<Bounded<W>>& triangle) {
    return enclosed_by_bounds(Plucker::roots(ray, triangle));
  }

  /// Where a ray from o along d meets the triangle, as met_exactly has them.
  template <class T, class Number, class Unit>
  [[nodiscard]] static FlatHit<T> meet(const Ray<T>& ray, const Triangle<T>& triangle, const Vec3<Number>& o,
                                       const Vec3<Number>& d, const Unit& unit) {
    if (!are_finite(triangle.a, triangle.b, triangle.c)) return no_hit<T>;
    step<T>("Find the side on which the ray passes each edge, exactly",
            "U, V and W are exact volumes of the direction and an edge; the ray hits where no two have "
            "opposite signs and their sum is not 0.");
    const auto a = unit * exact_vector<double>(triangle.a) - o;
    const auto b = unit * exact_vector<double>(triangle.b) - o;
    const auto c = unit * exact_vector<double>(triangle.c) - o;
    const auto bc = cross(b, c);
    const auto U = dot(d, bc);
    const auto V = dot(d, cross(c, a));
    const auto W = dot(d, cross(a, b));
    const auto D = U + V + W;
    if (sign(D) == 0 || sign(U) * sign(D) < 0 || sign(V) * sign(D) < 0 || sign(W) * sign(D) < 0) {
      return no_hit<T>;
    }

    step<T>(steps::round_quotients);
    return hit_at(rounded(ray, ExactRatio{dot(a, bc), D}), rounded_alone<T>(ExactRatio{V, D}),
                  rounded_alone<T>(ExactRatio{W, D}));
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
