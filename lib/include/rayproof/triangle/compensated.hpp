#pragma once
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/formulas/finite.hpp>
#include <rayproof/method/contract.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/method/sources.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/clear_sides.hpp>

namespace rayproof::triangle {

/// The three Plücker sides and the quotients of t, u and v as exact expansions in double: edges, vertices and
/// rays inside the plane are judged exactly, t, u and v are within 0.501 ulp, and t is never rounded across
/// an end of the ray's interval.
///
/// The same formula in double, with a bound on its rounding, goes first: it decides clear misses, and for a
/// ray in float clear hits as well. Holds for all finite floats; for doubles while every number that is not 0
/// lies within 2^±200, beyond which terms of the expansions over- or underflow.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "exact signs of the three sides by expansions";
  static constexpr Source source = sources::shewchuk;
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0},
      .residual = {.measured = 0.344, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 1},
      .domain = {.reach_float = 1000, .reach_double = 200, .every_number = true},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::ulp, Claim::robust,
                                       Claim::moved, Claim::scaled, Claim::reversed}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    if (!are_finite(ray.origin, ray.direction, triangle.a, triangle.b, triangle.c)) return no_hit<T>();
    const ClearSides clear(convert<double>(ray), convert<double>(triangle));
    if (clear.is_miss()) return no_hit<T>();
    if constexpr (sizeof(T) < sizeof(double)) {
      if (clear.is_hit(convert<double>(ray), double{std::numeric_limits<T>::min()}, infinite_from<T>)) {
        return flat_hit(true, static_cast<T>(clear.t()), static_cast<T>(clear.u()),
                        static_cast<T>(clear.v()));
      }
    }
    return exact_hit(ray, triangle);
  }

 private:
  template <class T>
  static FlatHit<T> no_hit() {
    return flat_hit(false, T(not_a_number<T>), T(not_a_number<T>), T(not_a_number<T>));
  }

  template <class T>
  static FlatHit<T> exact_hit(const Ray<T>& ray, const Triangle<T>& triangle) {
    step<T>("Find the side on which the ray passes each edge, exactly",
            "U, V and W are exact volumes of the direction and an edge; the ray hits where no two have "
            "opposite signs and their sum is not 0.");
    const auto o = exact_vector<double>(ray.origin);
    const auto d = exact_vector<double>(ray.direction);
    const auto a = exact_vector<double>(triangle.a) - o;
    const auto b = exact_vector<double>(triangle.b) - o;
    const auto c = exact_vector<double>(triangle.c) - o;
    const auto bc = cross(b, c);
    const auto U = dot(d, bc);
    const auto V = dot(d, cross(c, a));
    const auto W = dot(d, cross(a, b));
    const auto D = U + V + W;
    if (sign(D) == 0 || sign(U) * sign(D) < 0 || sign(V) * sign(D) < 0 || sign(W) * sign(D) < 0) {
      return no_hit<T>();
    }

    step<T>(steps::round_quotients);
    return flat_hit(true, rounded(ray, ExactRatio{dot(a, bc), D}), rounded_alone<T>(ExactRatio{V, D}),
                    rounded_alone<T>(ExactRatio{W, D}));
  }
};

}  // namespace rayproof::triangle
