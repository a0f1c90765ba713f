#pragma once
#include <rayproof/arithmetic.hpp>
#include <rayproof/triangle.hpp>

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

  /// All sides are clear and of one sign, and t, u and v are good to 2^-34, clear of both ends of the ray's
  /// interval and of the ends of the normal numbers.
  [[nodiscard]] bool is_hit(const Ray<double>& ray, double least, double too_large) const {
    const bool is_inside = (U_.value > U_.error && V_.value > V_.error && W_.value > W_.error) ||
                           (U_.value < -U_.error && V_.value < -V_.error && W_.value < -W_.error);
    if (!is_inside || !V_.has_digits() || !W_.has_digits() || !D_.has_digits() || !at_origin_.has_digits()) {
      return false;
    }
    const double size = abs(t());
    const auto is_beside = [](double x, double end) { return abs(x - end) <= 0x1p-22 * abs(x); };
    return size >= least && u() >= least && v() >= least && !is_beside(t(), ray.t_min) &&
           !is_beside(t(), ray.t_max) && !is_beside(size, too_large);
  }

  [[nodiscard]] double t() const { return at_origin_.value / D_.value; }
  [[nodiscard]] double u() const { return V_.value / D_.value; }
  [[nodiscard]] double v() const { return W_.value / D_.value; }

 private:
  struct Volume {
    double value = 0;
    double error = 0;
    [[nodiscard]] bool has_digits() const { return abs(value) >= 0x1p36 * error; }
  };

  static Volume volume(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
    return {dot(x, cross(y, z)), 0x1p-49 * size(x) * size(y) * size(z)};
  }
  static double size(const glm::dvec3& x) { return abs(x.x) + abs(x.y) + abs(x.z); }

  Volume U_, V_, W_, D_, at_origin_;
};

}  // namespace rayproof::triangle
