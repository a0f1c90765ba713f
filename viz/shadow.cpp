#include "viz/shadow.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <new>

namespace rayproof::viz {

using Number = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<320, boost::multiprecision::digit_base_2, void, std::int32_t>,
    boost::multiprecision::et_off>;

/// The number that a shadow is.
struct Inside {
  static_assert(sizeof(Shadow::room_) >= sizeof(Number) && alignof(Shadow) >= alignof(Number));
  static_assert(std::is_trivially_destructible_v<Number>);

  static const Number& of(const Shadow& x) { return *std::launder(reinterpret_cast<const Number*>(x.room_)); }
  static Shadow shadow(const Number& number) {
    Shadow x{Shadow::Unset{}};
    put(x, number);
    return x;
  }
  static void put(Shadow& x, const Number& number) { new (x.room_) Number(number); }
};

Shadow::Shadow(Exactly exactly) { Inside::put(*this, Number(exactly.value)); }
Shadow::Shadow(const Shadow& x) { Inside::put(*this, Inside::of(x)); }
Shadow& Shadow::operator=(const Shadow& x) {
  if (this != &x) Inside::put(*this, Inside::of(x));
  return *this;
}

Shadow::operator double() const { return static_cast<double>(Inside::of(*this)); }
Shadow::operator float() const { return static_cast<float>(Inside::of(*this)); }

Shadow operator-(const Shadow& x) { return Inside::shadow(-Inside::of(x)); }
Shadow operator+(const Shadow& x, const Shadow& y) { return Inside::shadow(Inside::of(x) + Inside::of(y)); }
Shadow operator-(const Shadow& x, const Shadow& y) { return Inside::shadow(Inside::of(x) - Inside::of(y)); }
Shadow operator*(const Shadow& x, const Shadow& y) { return Inside::shadow(Inside::of(x) * Inside::of(y)); }
Shadow operator/(const Shadow& x, const Shadow& y) { return Inside::shadow(Inside::of(x) / Inside::of(y)); }

bool operator==(const Shadow& x, const Shadow& y) { return Inside::of(x) == Inside::of(y); }
std::partial_ordering operator<=>(const Shadow& x, const Shadow& y) {
  if (Inside::of(x) < Inside::of(y)) return std::partial_ordering::less;
  if (Inside::of(x) > Inside::of(y)) return std::partial_ordering::greater;
  return x == y ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
}

bool isfinite(const Shadow& x) { return isfinite(Inside::of(x)); }
bool isinf(const Shadow& x) { return isinf(Inside::of(x)); }
bool isnan(const Shadow& x) { return isnan(Inside::of(x)); }

Shadow abs(const Shadow& x) { return Inside::shadow(abs(Inside::of(x))); }
Shadow fma(const Shadow& x, const Shadow& y, const Shadow& z) {
  return Inside::shadow(fma(Inside::of(x), Inside::of(y), Inside::of(z)));
}
Shadow sqrt(const Shadow& x) { return Inside::shadow(sqrt(Inside::of(x))); }
Shadow pow(const Shadow& x, int n) { return Inside::shadow(pow(Inside::of(x), n)); }
Shadow ldexp(const Shadow& x, int e) { return Inside::shadow(ldexp(Inside::of(x), e)); }
Shadow frexp(const Shadow& x, int* e) { return Inside::shadow(frexp(Inside::of(x), e)); }

std::string scientific(const Shadow& x, int digits) {
  return Inside::of(x).str(digits - 1, std::ios_base::scientific);
}

}  // namespace rayproof::viz
