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
/// With u = 2^-53 a product is off by at most 8u² of its exact result, a quotient by 11u², a root by 3.2u²,
/// a sum by 3u² of the sizes of its terms, |x| + |y|, and a sum of three products, by sum_of_products, by
/// 21u² of the sizes of these, all but for terms in u³. A sum that is exactly 0 is 0. Sums of two doubles are
/// exact, and products, too. All holds while nothing over- or underflows; that is why a given number counts
/// as NaN unless it is 0, infinite, or of a size from 2^-64 to 2^64: then no product of as many as eight
/// does. What comes of numbers that are not finite is not finite either, but may be NaN where a double is
/// infinite.
///
/// A sum: that of the lower parts is off by u²(|x| + |y|), and 2u²(|x| + |y|) more where it is added to what
/// the sum of the upper parts, s, leaves. Where s leaves anything it is larger than what is added to it.
/// Where not, |s| may be smaller than the sum of the lower parts, which is no more than half an ulp of each
/// upper part: but then these are of neighbouring binades or of one, s is a multiple of the smaller ulp, and
/// what is added to it less than two of these. So its exponent is no larger than that of s, or s is 0.
///
/// A sum of products: each is off by 8u² of its size, and its rest no more than 3u of it. The rests are added
/// to what the two sums of upper parts leave: off by u² of 3, 4, 4 and 5 times the sizes that they are of.
///
/// Sources: M. Joldes, J.-M. Muller, V. Popescu, "Tight and Rigorous Error Bounds for Basic Building Blocks
/// of Double-Word Arithmetic", 2017 (algorithms 5 and 10); V. Lefèvre, N. Louvet, J.-M. Muller, J. Picot, L.
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

  /// The same number in all lanes.
  template <std::same_as<Plain> U>
  requires(!std::is_arithmetic_v<W>) constexpr explicit DoubleDouble(const DoubleDouble<U>& same)
      : high_(same.high()), low_(same.low()) {}

  /// A given number of any size, for those who know what under- and overflow may do to it.
  [[nodiscard]] static constexpr DoubleDouble of_any_size(const W& given) { return {given, W(0)}; }

  [[nodiscard]] constexpr const W& high() const { return high_; }
  [[nodiscard]] constexpr const W& low() const { return low_; }

  friend constexpr DoubleDouble operator-(const DoubleDouble& x) { return {-x.high_, -x.low_}; }

  friend constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    return with_rest(two_sum(x.high_, y.high_), sum(x.low_, y.low_));
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

  /// One end of what x may be, where y is a bound on its error: off by u² of x and 2u of y. An infinite x
  /// stays infinite and keeps its place among all numbers, but is no longer equal to anything.
  friend constexpr DoubleDouble operator+(const DoubleDouble& x, const W& y) {
    return of_ordered(x.high_, x.low_ + y);
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& x, const W& y) { return x + -y; }

  friend constexpr DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    return with_rest(two_product(x.high_, y.high_), sum(product(x.high_, y.low_), product(y.high_, x.low_)));
  }

  /// a·b + c·d + e·f, in fewer steps than by products and sums, which put the parts of each result in order.
  friend constexpr DoubleDouble sum_of_products(const DoubleDouble& a, const DoubleDouble& b,
                                                const DoubleDouble& c, const DoubleDouble& d,
                                                const DoubleDouble& e, const DoubleDouble& f) {
    const ErrorFree<W> ab = loose_product(a, b), cd = loose_product(c, d), ef = loose_product(e, f);
    const ErrorFree<W> two = two_sum(ab.rounded, cd.rounded), all = two_sum(two.rounded, ef.rounded);
    return in_order(all.rounded, ((ab.rest + cd.rest) + two.rest) + (ef.rest + all.rest));
  }
  /// What the quotient of the upper parts leaves of x is x - quotient·y, of which the upper parts' share is
  /// exact: off by 5u² of x, with what it is divided by by 6u² more.
  friend constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const W quotient = x.high_ / y.high_;
    const W remainder = fma(-quotient, y.high_, x.high_) + fma(-quotient, y.low_, x.low_);
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

  /// What the upper parts come to, exactly, and what there is to be added to it: nothing where the lower
  /// parts are known to be 0, which those of given numbers are.
  static constexpr DoubleDouble with_rest(const ErrorFree<W>& upper, const W& lower) {
    if (is_known_zero(lower)) return {upper.rounded, upper.rest};
    return of_ordered(upper.rounded, upper.rest + lower);
  }
  /// A product whose parts are not put in order.
  static constexpr ErrorFree<W> loose_product(const DoubleDouble& x, const DoubleDouble& y) {
    const ErrorFree<W> high = two_product(x.high_, y.high_);
    return {high.rounded, sum(high.rest, sum(product(x.high_, y.low_), product(y.high_, x.low_)))};
  }
  static constexpr DoubleDouble in_order(const W& x, const W& y) {
    const ErrorFree<W> both = two_sum(x, y);
    return {both.rounded, both.rest};
  }
  static constexpr W sum(const W& x, const W& y) {
    return is_known_zero(x) ? y : is_known_zero(y) ? x : x + y;
  }
  static constexpr W product(const W& x, const W& y) { return is_known_zero(y) ? y : x * y; }

  /// 0 and infinity are half their own size.
  static constexpr W usual(const W& given) {
    const W size = abs(given);
    const Mask<W> is_usual = size == max(W(0x1p-64), min(W(0x1p64), size));
    return select(is_usual || W(0.5) * size == size, given, W(not_a_number<W>));
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

/// More than any operation's bound, and more than five times that of a sum, in parts of |x| + |y|; a sum of
/// three products is off by less than its five operations one by one.
template <class W>
inline constexpr double unit_roundoff<DoubleDouble<W>> = 0x1p-102;

/// x + more, rounded to double.
template <class W>
[[nodiscard]] constexpr W narrowed(const DoubleDouble<W>& x, const W& more) {
  return x.high() + (x.low() + more);
}

/// The number rounded to double.
template <class W>
[[nodiscard]] constexpr const W& narrow(const DoubleDouble<W>& x) {
  return x.high();
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
