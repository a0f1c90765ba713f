#include "oracle/numbers/rounding.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rayproof::oracle {
namespace {

/// The floats of type T in order as consecutive integers, so that neighbours and halfway points are
/// arithmetic.
template <class T, class Integer>
struct FloatGrid {
  static constexpr Integer sign_bit = std::numeric_limits<Integer>::min();
  static constexpr Integer infinity = std::bit_cast<Integer>(std::numeric_limits<T>::infinity());

  static Integer index(T x) {
    const auto bits = std::bit_cast<Integer>(x);
    return bits < 0 ? sign_bit - bits : bits;
  }
  static T at(Integer index) { return std::bit_cast<T>(index < 0 ? sign_bit - index : index); }

  /// The number as the ring has it; infinity stands for the power of two that would follow the largest
  /// number.
  static Ring exact(Integer index) {
    if (index == infinity || index == -infinity) {
      const Ring half = Ring(std::ldexp(1.0, std::numeric_limits<T>::max_exponent - 1));
      return index > 0 ? half + half : -(half + half);
    }
    return Ring(static_cast<double>(at(index)));
  }

  /// The sign of (number - the point halfway between `index` and its upper neighbour).
  template <class Number>
  static int compare_halfway(const Number& number, Integer index) {
    return number.compare((exact(index) + exact(index + 1)) * Ring(0.5));
  }

  /// Whether `index` or its upper neighbour is nearer; a tie goes to the even one.
  template <class Number>
  static bool rounds_above(const Number& number, Integer index) {
    const int side = compare_halfway(number, index);
    return side > 0 || (side == 0 && index % 2 != 0);
  }
};

template <class T, class Integer, class Number>
double round_in(const Number& number) {
  using Floats = FloatGrid<T, Integer>;
  const auto guess = static_cast<T>(number.estimate().value());
  Integer low = Floats::index(guess);  // the answer is known to be >= low + 1 or low is the answer
  // The estimate is nearly always right or one off: walk a few steps, and bisect if that was not enough.
  for (int step = 0; step < 4; ++step) {
    if (low < Floats::infinity && Floats::rounds_above(number, low)) {
      ++low;
    } else if (low > -Floats::infinity && !Floats::rounds_above(number, low - 1)) {
      --low;
    } else {
      return static_cast<double>(Floats::at(low));
    }
  }
  low = -Floats::infinity;
  Integer high = Floats::infinity;
  while (low < high) {
    const Integer middle = std::midpoint(low, high);
    if (Floats::rounds_above(number, middle)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return static_cast<double>(Floats::at(low));
}

template <class Number>
double round_number(const Number& number, Precision precision) {
  const double rounded = precision == Precision::float32 ? round_in<float, std::int32_t>(number)
                                                         : round_in<double, std::int64_t>(number);
  // IEEE 754 rounds a negative number that is too small for its precision to -0.
  return rounded == 0 && number.compare(Ring(0.0)) < 0 ? -0.0 : rounded;
}

}  // namespace

double round_correctly(const ExactRoot& root, Precision precision) { return round_number(root, precision); }
double round_correctly(const Quotient& quotient, Precision precision) {
  return round_number(quotient, precision);
}

}  // namespace rayproof::oracle
