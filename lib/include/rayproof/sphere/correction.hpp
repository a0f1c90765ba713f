#pragma once
#include <rayproof/formulas/newton_step.hpp>
#include <rayproof/sphere/centred.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// The nearest hit of Centred, corrected: the zero of f(t) = |l|² - r² with l = o + t·d - c is found from f
/// and half its slope, g = l·d, at a t that is as short as the ray's own numbers. Whatever t is, what is sure
/// is right.
///
/// In real numbers f(t + x) = f(t) + 2g·x + a·x² with a = |d|². The discriminant g² - a·f(t) is the same for
/// every t, and its sign the verdict.
///
/// u is the unit roundoff of more digits. o - c and l are rounded once, products of given numbers are exact:
/// l is off by u(|o - c| + |l|), and |l|² - r² by u(|o - c|² + 7|l|² + 4r²). With |o - c| <= |l| + |t||d| and
/// |l|² <= |f| + r² that is less than u(9|f| + 13r² + 2t²a), and the first term far less than a rounding to
/// N.
///
/// A hit is sure where Newton's step is: the slope's error, a·x and more, is then less than a 2^10th of it,
/// so that a·f is less than g²/384, and g, off by u·(4|l| + |o - c|)·|d|, by less than 2^-27 of itself. Where
/// g < 0 it is the lower root. The other one lies 2√(g² - a·f)/a away, which is more than 1.99|g|/a.
///
/// A miss is sure where a·f > 4g² beside f's error: the error of g adds less than a·f/2 to g².
///
/// Nothing of this underflows, and what overflows is never sure, where a is no less than `least_error`.
struct Correction {
  /// Where to begin: the root that seems to be the nearest hit, or of a miss the t nearest to the centre.
  template <class N>
  [[nodiscard]] static constexpr CorrectionStart<N> start(const Ray<N>& ray, const Sphere<N>& sphere) {
    const auto [t_c, D, per_a] = Centred::cut_out(ray, sphere);
    const auto [discriminant, lo, hi] = ends_of_chord(t_c, max(D, N(0)), per_a);
    return {select(ray.t_min <= lo, lo, hi), N(0)};
  }

  /// f and g, found with more digits.
  template <class N, class W>
  [[nodiscard]] static constexpr Linear<N> residual(const Ray<N>& /*ray*/, const Ray<W>& wide,
                                                    const CorrectionStart<N>& /*narrow*/,
                                                    const CorrectionStart<W>& start,
                                                    const Sphere<W>& sphere) {
    const vec3<W> d = wide.direction, f = wide.origin - sphere.center;
    const vec3<W> l = multiply_add(start.t, d, f);
    return {narrow(dot(l, l) - sphere.radius * sphere.radius), narrow(dot(l, d))};
  }

  /// The nearest hit from f and g, infinity for a miss.
  template <class N, class W>
  [[nodiscard]] static constexpr Corrected<N> nearest(const Ray<N>& ray, const CorrectionStart<N>& start,
                                                      const Linear<N>& f, const Sphere<W>& sphere) {
    const N t = start.t;
    const auto& [value, g] = f;
    const W rr = sphere.radius * sphere.radius;
    const N a = dot(ray.direction, ray.direction);

    const N k(16 * unit_roundoff<W>);
    const N error = k * t * t * a + (k * narrow(rr) + N(least_error<N>));
    const auto curvature = [&](const N& step) { return N(1.5) * a * step; };
    const auto [root, is_root, from, step, doubt] = newton_step(t, value, error, N(2) * g, curvature);

    const N from_start = a * (root - ray.t_min), between = max(N(1.99) * g, N(0));
    const Mask<N> is_nearest = (from_start - between) * g < N(0);
    const Mask<N> is_on_end = root == ray.t_min || root == ray.t_max;
    const Mask<N> is_sure_hit = is_root && is_nearest && !is_on_end;
    const N least_value = min(value, N(1 / least_error<N>)) - N(8) * error;
    const Mask<N> is_sure_miss = N(4) * g * g < a * least_value;
    return {select(is_root && in_interval(ray, root), root, N(infinity<N>)),
            (is_sure_hit || is_sure_miss) && N(least_error<N>) < a, from, step, doubt};
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
