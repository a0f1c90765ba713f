#include "oracle/numbers/root.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace rayproof::oracle {
namespace {

/// The float as the ring R has it; infinity stands for the power of two that would follow the largest number.
template <class R, class T>
R exact(T x) {
  if (std::isfinite(x)) return R(static_cast<double>(x));
  const R half(std::copysign(std::ldexp(1.0, std::numeric_limits<T>::max_exponent - 1), x));
  return half + half;
}

template <class T>
bool is_odd(T x) {
  using Bits = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(x) % 2 != 0;
}

long double as_long_double(const Scaled& x) { return x.value(); }
long double as_long_double(long double x) { return x; }

/// An estimate is certain to one part in 2^58: nearly always whatever it can stand for rounds to one float.
/// Otherwise the exact number is compared with the point halfway between the two.
template <class T, class Number>
double round_in(const Number& number) {
  using R = typename Number::Over;
  const long double estimate = as_long_double(number.estimate()) + 0.0L;  // makes an exact -0 a 0
  const auto near = static_cast<T>(estimate * (1 - 0x1p-57L));
  const auto far = static_cast<T>(estimate * (1 + 0x1p-57L));
  if (near == far) return static_cast<double>(near);
  const int above = number.compare((exact<R>(near) + exact<R>(far)) * R(0.5));
  const int outwards = near < far ? above : -above;
  return static_cast<double>(outwards > 0 || (outwards == 0 && is_odd(near)) ? far : near);
}

}  // namespace

template <class Number>
double round_correctly(const Number& number, Precision precision) {
  return precision == Precision::float32 ? round_in<float>(number) : round_in<double>(number);
}

template double round_correctly(const ExactRoot&, Precision);
template double round_correctly(const Quotient&, Precision);
template double round_correctly(const RootOf<Estimate>&, Precision);
template double round_correctly(const QuotientOf<Estimate>&, Precision);

}  // namespace rayproof::oracle
