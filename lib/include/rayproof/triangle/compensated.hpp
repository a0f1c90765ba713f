#pragma once
#include <rayproof/formulas/exact_rounding.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/triangle.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// The three sides and the quotients of a ray and a triangle in double, with bounds on their rounding errors:
/// what is clear needs no exact arithmetic.
///
/// Every number here is the volume of three vectors that are differences of inputs. With |x| the sum of a
/// vector's magnitudes its error is less than 2^-50·|x||y||z|: two roundings of differences and at most six
/// of the volume, each 2^-53 of no more than that product. Nothing may underflow: true of floats in double;
/// of doubles only within the domain of the caller.
class ClearSides {
 public:
  ClearSides(const Ray<double>& ray, const Triangle<double>& triangle) {
    const glm::dvec3& d = ray.direction;
    const glm::dvec3 a = triangle.a - ray.origin;
    const glm::dvec3 b = triangle.b - ray.origin;
    const glm::dvec3 ab = triangle.b - triangle.a;
    const glm::dvec3 ac = triangle.c - triangle.a;
    // b×c = b×(c-b): so formed, the sides of a small far triangle keep their digits.
    U_ = volume(d, b, triangle.c - triangle.b);
    V_ = volume(d, ac, a);
    W_ = volume(d, a, ab);
    D_ = volume(d, ab, ac);
    at_origin_ = volume(a, ab, ac);
  }

  /// Two sides are clear and of different signs: the ray passes by.
  [[nodiscard]] bool is_miss() const {
    const bool any_positive = U_.value > U_.error || V_.value > V_.error || W_.value > W_.error;
    const bool any_negative = U_.value < -U_.error || V_.value < -V_.error || W_.value < -W_.error;
    return any_positive && any_negative;
  }

  /// Of what is no such miss: all sides are clear, and so of one sign, and t, u and v are good to 2^-34, t
  /// clear of both ends of the ray's interval and of the ends of T's normal numbers.
  template <class T>
  [[nodiscard]] bool is_hit(const Ray<double>& ray) const {
    const bool have_digits = V_.has_digits() && W_.has_digits() && D_.has_digits() && at_origin_.has_digits();
    return U_.is_clear() && have_digits && is_clear_of_ends<T>(ray, t());
  }

  [[nodiscard]] double t() const { return at_origin_.value / D_.value; }
  [[nodiscard]] double u() const { return V_.value / D_.value; }
  [[nodiscard]] double v() const { return W_.value / D_.value; }

 private:
  struct Volume {
    double value = 0;
    double error = 0;
    [[nodiscard]] bool is_clear() const { return abs(value) > error; }
    /// An error of 0 is that of an exact 0: a side that the ray meets, or a t that is none.
    [[nodiscard]] bool has_digits() const { return abs(value) >= 0x1p36 * error; }
  };

  static Volume volume(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
    return {dot(x, cross(y, z)), 0x1p-49 * size(x) * size(y) * size(z)};
  }
  static double size(const glm::dvec3& x) { return abs(x.x) + abs(x.y) + abs(x.z); }

  Volume U_, V_, W_, D_, at_origin_;
};

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
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.433, .promised = 2},
      .ulp = {.measured = 0.501, .promised = 0.51},
      .hit = triangle_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 200, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::coordinates, Claim::residual, Claim::ulp}};

  template <std::floating_point T>
  [[nodiscard]] static FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    if (!are_finite(ray.origin, ray.direction, triangle.a, triangle.b, triangle.c)) return no_hit<T>;
    const Ray<double> wide_ray = convert<double>(ray);
    const ClearSides clear(wide_ray, convert<double>(triangle));
    if (clear.is_miss()) return no_hit<T>;
    if (sizeof(T) < sizeof(double) && clear.is_hit<T>(wide_ray)) {
      return hit_at(T(clear.t()), T(clear.u()), T(clear.v()));
    }
    return exact_hit(ray, triangle);
  }

 private:
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
      return no_hit<T>;
    }

    step<T>(steps::round_quotients);
    return hit_at(rounded(ray, ExactRatio{dot(a, bc), D}), rounded_alone<T>(ExactRatio{V, D}),
                  rounded_alone<T>(ExactRatio{W, D}));
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
