#pragma once
#include <rayproof/formulas/bounded_roots.hpp>
#include <rayproof/formulas/exact_map.hpp>
#include <rayproof/sphere/compensated.hpp>
#include <rayproof/sphere/correction.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// Correctly rounded: the verdict is the exact one, and t the exact t rounded once, ties to even.
///
/// Centred runs in double for a ray in float, in double-double for one in double, in packs too; its answer
/// stands where the error bound below leaves no doubt of the discriminant's sign and of the rounding of t,
/// which is nearly everywhere. The rest goes to Compensated's expansions.
/// An answer is never rounded across an end of the ray's interval. Domain as Compensated's; under a transform
/// every number lies within 2^±24, so that the discriminant, of degree 14, neither over- nor underflows.
struct Rounded {
  static constexpr const char* name = "rounded";
  static constexpr const char* title = "correctly rounded: centred with more digits, exact where in doubt";
  static constexpr Source source = sources::ziv;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 1.0, .promised = 2},
      // Claim::rounded says more: the error of a tie is measured to a few ε.
      .ulp = {.measured = 0.5, .promised = 0.501},
      .hit = sphere_hit_bounds,
      .domain = Compensated::contract.domain,
      .holds =
          robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp, Claim::rounded, Claim::bounded}};

  /// What is tried first where the nearest hit alone is asked for.
  using Correction = sphere::Correction;

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    return quick_or_exact_roots<Rounded>(ray, sphere);
  }

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> exact_roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    return Compensated::exact_roots(ray, sphere);
  }

  /// The same under a transform.
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                               const Sphere<T>& sphere) {
    return quick_or_exact_roots<Rounded>(space, ray, sphere);
  }

  /// Centred of a ray in object space whose numbers have bounds on their errors.
  template <class W>
  [[nodiscard]] static constexpr Enclosed<W> enclosed_in_space(const Ray<Bounded<W>>& ray,
                                                               const Sphere<Bounded<W>>& sphere) {
    return enclosed_by_bounds(Centred::roots(ray, sphere));
  }

  /// The roots of a ray from o along d, as met_exactly has them.
  template <std::floating_point T, class Number, class Unit>
  [[nodiscard]] static Roots<T> meet(const Ray<T>& ray, const Sphere<T>& sphere, const Vec3<Number>& o,
                                     const Vec3<Number>& d, const Unit& unit) {
    if (!are_finite(sphere.center, sphere.radius)) return no_roots<T>;
    return Compensated::roots_of_exact(ray, o - unit * exact_vector<double>(sphere.center), d,
                                       unit * exact(double{sphere.radius}));
  }

  /// Centred in double on numbers that are floats, or in double-double on doubles, and what is known of it.
  ///
  /// u is the unit roundoff, S = |f| + r, and D, l, h are the numbers computed. f is rounded once; products
  /// of given numbers are exact, so that |d|² is off by 2u of its size and 1/|d|² by 3u. f·d is off by
  /// 4u|f||d| (f, products, two sums), t_c by 8u|f|/|d|. From those and its own product and sum l = f + t_c·d
  /// is off by 11u|f|, l·l by 11u|f|·(2|l| + 11u|f|) + 3u|l|², and D, whose r² is exact, by
  ///   δD <= u·S·(26|l| + r + 121u|f|) < 2^5·u·S·(r + |l| + 2^3·u·S).
  ///
  /// D < 0: then r < |l| <= |f|, but for their roundings, and δD² < 2^16·u²·|f|²·(|l|² + 2^6·u²·|f|²) with
  /// |l|² = r² - D. The test asks for four times that.
  ///
  /// D > 0: then |l| < r. Let k = (1 + r²/D)/2, which is no less than r/√D. From f = l - t_c·d and
  /// r/|d| = h·r/√D follows S/|d| <= |t_c| + 2hk = Q/2. The test h > 2^9·u·k·Q gives D > 2^9·u·S·r, so that
  /// r > 2^9·u·S and δD < 2^6.1·u·S·r < D/7. h = √(D/|d|²) is then off by 0.54·δD/D + 3u of its size, and a
  /// root by 8u·S/|d| + 0.58·2^6·u·k·S/|d| + 3u·h + u|t|, where h and |t| are no more than S/|d| each: by
  /// less than Q·(6u + 0.58·2^5·u·k). 2u of the 8u taken, and two fifths of the second term, are left for the
  /// rounding test and for roundings of the bound: Q, which is found by the roots, lacks 2u·k|t| at most, and
  /// k² is below 2^-10/u here.
  ///
  /// A sum of double-doubles is off by less than u/5 of the sizes of its terms, and not by u of itself; these
  /// are together no more than twice what is counted above, |f| for f and t_c·d, r·S and |l|·S for r² and
  /// |l|².
  ///
  /// Nothing over- or underflows: floats are whole multiples of 2^-149, and no product is of more than six.
  template <class W>
  [[nodiscard]] static constexpr Enclosed<W> enclosed(const Ray<W>& ray, const Sphere<W>& sphere) {
    using N = Leading<W>;
    constexpr double u = unit_roundoff<W>;
    const Roots<W> roots = Centred::roots(ray, sphere);
    const N D = leading(roots.discriminant);
    const auto f = leading(ray.origin - sphere.center);
    const N ff = dot(f, f);
    const N rr = square(leading(sphere.radius));
    const Mask<W> is_sure_miss = N(0x1p18 * u * u) * ff * ((rr - D) + N(0x1p6 * u * u) * ff) < D * D;

    const N k_twice = N(1) + rr * reciprocal_bound(D);
    const N h_twice = leading(roots.hi - roots.lo);
    const N Q = abs(leading(roots.hi) + leading(roots.lo)) + h_twice * k_twice;
    const Mask<W> is_sure_hit = N(0x1p9 * u) * (k_twice * Q) < h_twice;
    const Mask<W> is_hit = N(0) < D;
    const N error = Q * (N(8 * u) + N(16 * u) * k_twice);
    return {roots, error, error, (is_hit && is_sure_hit) || (!is_hit && is_sure_miss)};
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
