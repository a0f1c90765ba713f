#pragma once
/// \file
/// Numbers of twice a double's digits, each the sum of two doubles: for the quick phase of what is to be
/// rounded to double.

#include <rayproof/arithmetics/error_free.hpp>
#include <rayproof/vec3.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// high + low, where high is the sum rounded to double. `W` is double or a pack of them.
///
/// Each operation is off by at most 15u² of its exact result and terms in u³, u = 2^-53: a sum by 3u², a
/// product by 7u², a quotient by 15u², a root by 3.2u². Sums of two doubles are exact, and products, too. All
/// holds while nothing over- or underflows; that is why a given number counts as NaN unless it is 0,
/// infinite, or of a size from 2^-64 to 2^64: then no product of as many as eight does. What comes of numbers
/// that are not finite is not finite either, but may be NaN where a double is infinite.
///
/// Sources: M. Joldes, J.-M. Muller, V. Popescu, "Tight and Rigorous Error Bounds for Basic Building Blocks
/// of Double-Word Arithmetic", 2017 (algorithms 6, 10, 17); V. Lefèvre, N. Louvet, J.-M. Muller, J. Picot, L.
/// Rideau, "Accurate Calculation of Euclidean Norms Using Double-Word Arithmetic", 2023 (the root).
template <class W>
class DoubleDouble : public Comparable<DoubleDouble<W>> {
 public:
  using Plain = rayproof::Plain<W>;

  DoubleDouble() = default;
  /// A given number, or one for each lane.
  constexpr explicit DoubleDouble(const W& given) : high_(usual(given)), low_(0) {}
  /// A constant of a formula.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr explicit DoubleDouble(Number same) : high_(static_cast<Plain>(same)), low_(0) {}

  [[nodiscard]] constexpr const W& high() const { return high_; }
  [[nodiscard]] constexpr const W& low() const { return low_; }

  friend constexpr DoubleDouble operator-(const DoubleDouble& x) { return {-x.high_, -x.low_}; }

  friend constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const ErrorFree<W> high = two_sum(x.high_, y.high_), low = two_sum(x.low_, y.low_);
    const DoubleDouble sum = of_ordered(high.rounded, high.rest + low.rounded);
    return of_ordered(sum.high_, low.rest + sum.low_);
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

  /// With a double, an error say; an infinite x stays as it is.
  friend constexpr DoubleDouble operator+(const DoubleDouble& x, const W& y) {
    const ErrorFree<W> high = two_sum(x.high_, y);
    return select(abs(x.high_) < W(infinity<W>), of_ordered(high.rounded, high.rest + x.low_), x);
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& x, const W& y) { return x + -y; }

  friend constexpr DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const ErrorFree<W> high = two_product(x.high_, y.high_);
    return of_ordered(high.rounded, high.rest + (x.high_ * y.low_ + x.low_ * y.high_));
  }

  friend constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const W quotient = x.high_ / y.high_;
    const ErrorFree<W> high = two_product(y.high_, quotient);
    const DoubleDouble sum = of_ordered(high.rounded, y.low_ * quotient);
    const DoubleDouble product = of_ordered(sum.high_, sum.low_ + high.rest);
    const W remainder = (x.high_ - product.high_) + (x.low_ - product.low_);
    return of_ordered(quotient, remainder / y.high_);
  }

  /// NaN of a negative number.
  friend constexpr DoubleDouble sqrt(const DoubleDouble& x) {
    const W root = sqrt(x.high_);
    const W remainder = x.low_ + fma(-root, root, x.high_);
    const DoubleDouble refined = of_ordered(root, remainder / (W(2) * root));
    return select(x.high_ == W(0), x, refined);
  }

  friend constexpr auto operator<(const DoubleDouble& x, const DoubleDouble& y) {
    return x.high_ < y.high_ || (x.high_ == y.high_ && x.low_ < y.low_);
  }
  friend constexpr auto operator<=(const DoubleDouble& x, const DoubleDouble& y) {
    return x.high_ < y.high_ || (x.high_ == y.high_ && x.low_ <= y.low_);
  }
  friend constexpr auto operator==(const DoubleDouble& x, const DoubleDouble& y) {
    return x.high_ == y.high_ && x.low_ == y.low_;
  }

  friend constexpr DoubleDouble select(const Mask<W>& mask, const DoubleDouble& yes, const DoubleDouble& no) {
    return {select(mask, yes.high_, no.high_), select(mask, yes.low_, no.low_)};
  }
  friend constexpr DoubleDouble abs(const DoubleDouble& x) { return select(x.high_ < W(0), -x, x); }
  friend constexpr DoubleDouble min(const DoubleDouble& x, const DoubleDouble& y) {
    return select(y < x, y, x);
  }
  friend constexpr DoubleDouble max(const DoubleDouble& x, const DoubleDouble& y) {
    return select(x < y, y, x);
  }

 private:
  constexpr DoubleDouble(const W& high, const W& low) : high_(high), low_(low) {}

  /// The sum of two doubles, of which the first has the larger exponent or is 0 (T. J. Dekker, 1971).
  static constexpr DoubleDouble of_ordered(const W& large, const W& small) {
    const W sum = large + small;
    return {sum, small - (sum - large)};
  }

  static constexpr W usual(const W& given) {
    const W size = abs(given);
    const Mask<W> is_usual = W(0x1p-64) <= size && size <= W(0x1p64);
    return select(is_usual || size == W(0) || size == W(infinity<W>), given, W(not_a_number<W>));
  }

  W high_, low_;
};

/// The part that error bounds are computed in.
template <class W>
[[nodiscard]] constexpr const W& leading(const DoubleDouble<W>& x) {
  return x.high();
}
template <class W>
[[nodiscard]] constexpr vec3<W> leading(const Vec3<DoubleDouble<W>>& v) {
  return {v.x.high(), v.y.high(), v.z.high()};
}

/// 15u² and the terms in u³.
template <class W>
inline constexpr double unit_roundoff<DoubleDouble<W>> = 0x1p-102;

/// x + more, rounded to double.
template <class W>
[[nodiscard]] constexpr W narrowed(const DoubleDouble<W>& x, const W& more) {
  return x.high() + (x.low() + more);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
